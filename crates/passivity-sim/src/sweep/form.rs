//! The forms of a finished sweep's file: CSV and Parquet.

use std::path::Path;

use crate::error::SimError;
use crate::sweep::csv;
#[cfg(feature = "parquet")]
use crate::sweep::disk::failed;
use crate::sweep::grid::Grid;
#[cfg(feature = "parquet")]
use crate::sweep::parquet;
use crate::sweep::row::Found;

/// How the rows of a finished sweep are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Csv,
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Form {
    /// The form that the name of a file asks for.
    pub(super) fn of(path: &Path) -> Result<Self, SimError> {
        let parquet = path
            .extension()
            .is_some_and(|end| end.eq_ignore_ascii_case("parquet"));
        if !parquet {
            return Ok(Self::Csv);
        }
        #[cfg(feature = "parquet")]
        return Ok(Self::Parquet);
        #[cfg(not(feature = "parquet"))]
        Err(SimError::NotBuiltIn {
            what: "Parquet files are",
            feature: "parquet",
        })
    }

    /// The rows of a finished file.
    pub(super) fn read(self, path: &Path, grid: &Grid) -> Result<Vec<Found>, SimError> {
        match self {
            Self::Csv => csv::read(path, grid).map(|(rows, _)| rows),
            #[cfg(feature = "parquet")]
            Self::Parquet => parquet::read(path, grid).map_err(|error| failed(path, &error)),
        }
    }

    /// The error at a row, from 0.
    pub(super) fn at(self, path: &Path, row: usize, what: &str) -> SimError {
        match self {
            Self::Csv => csv::at(path, row, what),
            #[cfg(feature = "parquet")]
            Self::Parquet => failed(path, &format!("row {}: {what}", row + 1)),
        }
    }
}
