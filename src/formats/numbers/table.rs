//! Rows of numbers in little memory: one byte a number while all are whole and below 256, four otherwise.

use super::super::text::quote;
use crate::error::FormatError;
use crate::map::MAX_SIDE;

/// More numbers than any map has.
const MAX_NUMBERS: usize = (MAX_SIDE as usize) * (MAX_SIDE as usize);

/// Numbers in rows. A number is kept as an f32, which is what a height is.
#[derive(Default)]
pub(in crate::formats) struct Table {
    values: Values,
    /// For each row its line in the text, from 1, and where it ends among the values.
    rows: Vec<(u32, u32)>,
    /// Whether there was text around the numbers, such as the rest of a program.
    pub has_rest: bool,
}

enum Values {
    Small(Vec<u8>),
    Any(Vec<f32>),
}

impl Default for Values {
    fn default() -> Self {
        Self::Small(Vec::new())
    }
}

/// One row of a table.
#[derive(Clone, Copy)]
pub(in crate::formats) enum Row<'a> {
    Small(&'a [u8]),
    Any(&'a [f32]),
}

impl<'a> Row<'a> {
    /// How many numbers it has.
    pub fn len(self) -> usize {
        match self {
            Row::Small(values) => values.len(),
            Row::Any(values) => values.len(),
        }
    }

    /// A number of it.
    pub fn at(self, column: usize) -> f32 {
        match self {
            Row::Small(values) => f32::from(values[column]),
            Row::Any(values) => values[column],
        }
    }

    /// Its numbers from left to right.
    pub fn iter(self) -> impl Iterator<Item = f32> + use<'a> {
        (0..self.len()).map(move |column| self.at(column))
    }
}

impl Values {
    fn len(&self) -> usize {
        match self {
            Self::Small(values) => values.len(),
            Self::Any(values) => values.len(),
        }
    }

    fn push(&mut self, value: f32) {
        if let Self::Small(values) = self {
            let small = value as u8;
            if f32::from(small).to_bits() == value.to_bits() {
                return values.push(small);
            }
            *self = Self::Any(values.iter().map(|&small| f32::from(small)).collect());
        }
        if let Self::Any(values) = self {
            values.push(value);
        }
    }
}

impl Table {
    /// Adds a number to the row that has begun.
    ///
    /// # Errors
    /// [`FormatError::TooLarge`] beyond the cells of the largest map.
    pub fn push(&mut self, value: f32) -> Result<(), FormatError> {
        if self.values.len() >= MAX_NUMBERS {
            let max = format!("{MAX_SIDE} × {MAX_SIDE} cells");
            return Err(FormatError::TooLarge { what: "the number of cells".into(), max });
        }
        self.values.push(value);
        Ok(())
    }

    /// Ends a row of at least one number.
    ///
    /// # Errors
    /// [`FormatError::TooLarge`] for more rows than four times the side of a map, of one number each.
    pub fn end_row(&mut self, line: usize) -> Result<(), FormatError> {
        const MAX_ROWS: usize = 1 << 20;
        let end = self.values.len() as u32;
        if end == self.rows.last().map_or(0, |row| row.1) {
            return Ok(());
        }
        if self.rows.len() >= MAX_ROWS {
            let max = format!("{MAX_ROWS} rows");
            return Err(FormatError::TooLarge { what: "the number of rows".into(), max });
        }
        self.rows.push((line as u32, end));
        Ok(())
    }

    /// How many rows there are.
    pub fn height(&self) -> usize {
        self.rows.len()
    }

    /// The line of a row in the text, from 1.
    pub fn line(&self, row: usize) -> usize {
        self.rows.get(row).map_or(0, |row| row.0 as usize)
    }

    /// A row; empty for one that is not there.
    pub fn row(&self, row: usize) -> Row<'_> {
        let from = row.checked_sub(1).and_then(|before| self.rows.get(before)).map_or(0, |before| before.1 as usize);
        let to = self.rows.get(row).map_or(from, |row| row.1 as usize);
        match &self.values {
            Values::Small(values) => Row::Small(&values[from..to]),
            Values::Any(values) => Row::Any(&values[from..to]),
        }
    }

    /// All rows.
    pub fn rows(&self) -> impl DoubleEndedIterator<Item = Row<'_>> {
        (0..self.height()).map(|row| self.row(row))
    }

    /// All numbers, row by row.
    pub fn numbers(&self) -> impl Iterator<Item = f32> {
        self.rows().flat_map(Row::iter)
    }

    /// Columns and rows.
    ///
    /// # Errors
    /// [`FormatError::Syntax`] with the line of a row that is longer or shorter than the first.
    pub fn size(&self) -> Result<(usize, usize), FormatError> {
        let width = self.row(0).len();
        if let Some((index, row)) = self.rows().enumerate().find(|(_, row)| row.len() != width) {
            let what = format!("row {} has {} numbers where the first row has {width}", index + 1, row.len());
            return Err(FormatError::syntax(self.line(index), what, "equally long rows"));
        }
        Ok((width, self.height()))
    }

    /// Whether another table holds the same numbers in the same rows.
    pub fn same_numbers(&self, other: &Self) -> bool {
        let ends = |table: &Self| table.rows.iter().map(|row| row.1).collect::<Vec<_>>();
        self.values.len() == other.values.len() && ends(self) == ends(other) && self.numbers().eq(other.numbers())
    }

    /// Without the first rows, and without the first column where that is asked for.
    pub fn without(self, rows: usize, first_column: bool) -> Self {
        let mut rest = Self { has_rest: self.has_rest, ..Self::default() };
        for at in rows..self.height() {
            for value in self.row(at).iter().skip(usize::from(first_column)) {
                rest.values.push(value);
            }
            rest.rows.push((self.rows[at].0, rest.values.len() as u32));
        }
        rest
    }

    /// Puts the rows of another table behind this one's.
    ///
    /// # Errors
    /// [`FormatError::Syntax`] where it has another number of rows.
    pub fn beside(&self, other: &Self) -> Result<Self, FormatError> {
        if self.height() != other.height() {
            let what = format!("these columns have {} rows where the first have {}", other.height(), self.height());
            return Err(FormatError::syntax(other.line(0), what, "the same rows in every block of columns"));
        }
        let mut both = Self::default();
        for (index, (left, right)) in self.rows().zip(other.rows()).enumerate() {
            left.iter().chain(right.iter()).try_for_each(|value| both.push(value))?;
            both.end_row(self.line(index))?;
        }
        Ok(both)
    }
}

/// A number as it stands in a table; none for what is no finite one.
pub(super) fn number(token: &str) -> Option<f32> {
    match token.as_bytes() {
        // Nearly all numbers of a map.
        [digit] if digit.is_ascii_digit() => Some(f32::from(digit - b'0')),
        _ => token.parse::<f64>().ok().filter(|v| v.is_finite()).map(|v| v as f32),
    }
}

/// The error for what is no number.
pub(super) fn no_number(line: usize, token: &str) -> FormatError {
    FormatError::syntax(line, format!("`{}` is no number", quote(token)), "numbers")
}
