//! Columns that were told by names that the header does not have: which may be meant.

use passivity_scene::Scene;

use super::{Assignment, Columns, Found};
use crate::log::guess;
use crate::log::header::{Heading, split};
use crate::log::names::by_name;
use crate::log::preview::Preview;

impl Columns {
    /// What was told, with the roles, units and signs that were typed; `None` where for one of the names no column is
    /// likely.
    pub(crate) fn meant(
        &self,
        headings: &[Heading],
        preview: &Preview,
        scene: &Scene,
    ) -> Option<Vec<Found>> {
        let found: Vec<Option<Found>> = self.0.iter().map(|a| a.find(headings).ok()).collect();
        let times = |column| {
            found
                .iter()
                .flatten()
                .filter(|f| f.column == column)
                .count()
        };
        let once = found.iter().flatten().filter(|f| times(f.column) == 1);
        let mut meant: Vec<Found> = once.cloned().collect();
        let said = by_name(headings).unwrap_or_default();
        for (assignment, found) in self.0.iter().zip(&found) {
            if meant.iter().any(|other| other.role == assignment.role) {
                continue;
            }
            let is_free = |column: &usize| meant.iter().all(|other| other.column != *column);
            let alike = match found {
                // The name is there, and is said to be two things.
                Some(_) => None,
                None => assignment.most_alike(headings),
            };
            let is_kin = |found: &&Found| guess::are_kin(found.role, assignment.role);
            let guessed = || {
                let unread = guess::unread(headings, preview, scene, &meant);
                let mut known = said
                    .iter()
                    .chain(&unread)
                    .filter(|found| is_free(&found.column));
                known.find(is_kin).map(|found| found.column)
            };
            let column = alike.filter(is_free).or_else(guessed)?;
            // A column that is called `count` has no angles, whatever was typed of one that is not there.
            let mut own = said.iter().filter(is_kin);
            let own = own.find(|own| own.column == column && own.role != assignment.role);
            meant.push(own.cloned().unwrap_or_else(|| assignment.at(column)));
        }
        Some(meant)
    }
}

impl Assignment {
    /// The name that was typed, its unit, and whether it has a minus sign.
    fn typed(&self) -> (&str, Option<String>, bool) {
        let unsigned = self.text.strip_prefix('-').filter(|_| self.role.has_sign());
        let text = unsigned.unwrap_or(&self.text).trim();
        match split(text).ok().filter(|_| !self.quoted) {
            Some(split) => {
                let unit = split.unit.map(|unit| unit.into_owned());
                (split.stem, unit, unsigned.is_some())
            }
            None => (text, self.unit.clone(), unsigned.is_some()),
        }
    }

    /// What was typed, of this column.
    fn at(&self, column: usize) -> Found {
        let (_, unit, reversed) = self.typed();
        Found {
            role: self.role,
            column,
            unit,
            reversed,
        }
    }

    /// The column whose name is the most like the one that was typed: two thirds of it at both ends.
    fn most_alike(&self, headings: &[Heading]) -> Option<usize> {
        let letters = |text: &str| text.to_lowercase().chars().collect::<Vec<char>>();
        let typed = letters(self.typed().0);
        let alike = |heading: &Heading| {
            let own = letters(split(&heading.name).map_or(&heading.name, |split| split.stem));
            let pairs = own.iter().zip(&typed);
            let front = pairs.take_while(|(a, b)| a == b).count();
            let pairs = own.iter().rev().zip(typed.iter().rev());
            let back = pairs.take_while(|(a, b)| a == b).count();
            (front + back).min(own.len())
        };
        let of_each = headings.iter().map(alike).enumerate();
        // Of equals the first column.
        let (column, alike) = of_each.rev().max_by_key(|(_, alike)| *alike)?;
        (3 * alike >= 2 * typed.len()).then_some(column)
    }
}
