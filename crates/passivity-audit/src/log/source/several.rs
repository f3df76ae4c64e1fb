//! Several logs that are told one way to be read, each a log of its own.

use std::path::Path;

use passivity_scene::Scene;

use super::{Dialect, open};
use crate::log::columns::NO_COLUMN;
use crate::log::error::TraceError;
use crate::log::lines::BLOCK;

/// How each of several logs is read: as was told, but for those without the columns that were named, whose headers say
/// themselves what their columns are. One that was named must be in some log.
///
/// # Errors
///
/// [`TraceError`] for a log without the columns that were named and with such a header, with its file.
pub fn dialects<'p>(
    logs: &[&'p Path],
    scene: &Scene,
    told: &Dialect,
) -> Result<Vec<Dialect>, Box<(&'p Path, TraceError)>> {
    let mut found = vec![told.clone(); logs.len()];
    if told.columns.is_none() || logs.len() < 2 {
        return Ok(found);
    }
    let own = Dialect {
        columns: None,
        ..told.clone()
    };
    let (mut is_named, mut unnamed) = (false, None);
    for (path, dialect) in logs.iter().zip(&mut found) {
        let read = |dialect: &Dialect| open(path, BLOCK)?.read(scene, dialect).map(drop);
        let mut error = match read(told) {
            Err(error) if error.kind == NO_COLUMN => error,
            // What else is wrong is told where it is read.
            _ => {
                is_named = true;
                continue;
            }
        };
        match [own.clone(), Dialect::default()]
            .into_iter()
            .find(|own| read(own).is_ok())
        {
            Some(own) => *dialect = own,
            None if is_named => {
                error.message += "; the logs of one command must have the same names of columns, or such as say themselves \
                    what is in them, as `t [s]`, `count` and `f [N m]` do";
                // Another log was read by the names that were told.
                error.proposal = None;
                return Err(Box::new((*path, error)));
            }
            None => return Err(Box::new((*path, error))),
        }
        unnamed.get_or_insert((*path, error));
    }
    match unnamed {
        Some(error) if !is_named => Err(Box::new(error)),
        _ => Ok(found),
    }
}
