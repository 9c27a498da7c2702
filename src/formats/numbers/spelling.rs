//! Rows that are spelled in ways that would be read as other numbers: decimal commas, and the row and column numbers of R.

use std::borrow::Cow;

use crate::error::{FormatError, Notice};

/// Lines that are looked at to tell decimal commas from commas between numbers.
const LOOKED_AT: usize = 200;

/// A text without brackets as its numbers are meant, and what was assumed.
///
/// # Errors
/// [`FormatError::Syntax`] where a comma may be decimal or stand between two numbers.
pub(super) fn plain(text: &str) -> Result<(Cow<'_, str>, Option<Notice>), FormatError> {
    quoted_commas(text)?;
    match separator_of_decimals(text)? {
        None => Ok((Cow::Borrowed(text), None)),
        Some(_) => {
            let notice = Notice::new("matrix-decimal-commas", "commas within numbers were read as decimal commas");
            Ok((Cow::Owned(text.replace(',', ".")), Some(notice)))
        }
    }
}

/// What stands between numbers with decimal commas; none where commas stand between numbers.
fn separator_of_decimals(text: &str) -> Result<Option<char>, FormatError> {
    let mut rows = rows(text).filter(|(_, row)| row.contains(',')).take(LOOKED_AT).peekable();
    let Some(&(line, first)) = rows.peek() else { return Ok(None) };
    let decimals = |row: &str, separator: char| {
        let mut fields = row.split(separator).map(bare).filter(|field| !field.is_empty());
        fields.clone().nth(1).is_some() && fields.all(|field| is_decimal(field) || !field.contains(','))
    };
    // A row of numbers that end with `;` is MATLAB's: of Excel's every line has several fields, and there are several lines.
    let several = rows.clone().nth(1).is_some();
    for separator in [';', '\t'] {
        if several && rows.clone().all(|(_, row)| decimals(row, separator)) {
            return Ok(Some(separator));
        }
    }
    let words: Vec<&str> = first.split_whitespace().collect();
    if words.len() > 1 && words.iter().all(|word| is_decimal(bare(word))) {
        let what = format!("`{:.30}` may be one number with a decimal comma, or two numbers", words[0]);
        return Err(FormatError::syntax(line, what, "decimal points, or nothing but commas between numbers"));
    }
    Ok(None)
}

/// Refuses numbers within quotation marks that hold a comma: a thousand, or a decimal.
fn quoted_commas(text: &str) -> Result<(), FormatError> {
    for (line, row) in rows(text).filter(|(_, row)| row.contains('"')).take(LOOKED_AT) {
        let within = row.split('"').skip(1).step_by(2);
        if row.contains(';') || row.contains('\t') {
            continue;
        }
        if let Some(field) = within.filter(|field| field.contains(',')).find(|field| is_grouped(field)) {
            let what = format!("the comma in `{field:.30}` may be a decimal comma, or stand between thousands");
            return Err(FormatError::syntax(line, what, "numbers with a decimal point, and nothing between thousands"));
        }
    }
    Ok(())
}

/// The lines that are not blank, with their numbers from 1.
fn rows(text: &str) -> impl Iterator<Item = (usize, &str)> + Clone {
    text.lines().enumerate().map(|(index, line)| (index + 1, line)).filter(|(_, line)| !line.trim().is_empty())
}

fn bare(field: &str) -> &str {
    field.trim().trim_matches('"').trim()
}

/// `12,5`: digits on both sides of a single comma, perhaps below 0.
fn is_decimal(field: &str) -> bool {
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
    let unsigned = field.strip_prefix(['-', '+']).unwrap_or(field);
    unsigned.split_once(',').is_some_and(|(whole, part)| digits(whole) && digits(part.split(['e', 'E']).next().unwrap_or("")))
}

/// `1,5` or `1,234,567`: digits and commas alone.
fn is_grouped(field: &str) -> bool {
    let field = field.trim().trim_start_matches(['-', '+']);
    field.split(',').all(|part| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit() || b == b'.'))
}

/// What R prints of a matrix, `[1,]  0 0 1` below `[,1] [,2] [,3]`, as rows of numbers; none of another text.
pub(super) fn of_r(text: &str) -> Option<String> {
    let label = |line: &str, row: bool| {
        let (number, rest) = line.trim_start().strip_prefix('[')?.split_once(']').map(|(a, b)| (a.to_owned(), b.to_owned()))?;
        let digits = if row { number.strip_suffix(',') } else { number.strip_prefix(',') }?.to_owned();
        digits.parse::<u32>().is_ok().then_some(rest)
    };
    let mut lines = rows(text);
    let mut head = lines.next()?.1.to_owned();
    while !head.trim().is_empty() {
        head = label(&head, false)?;
    }
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        match label(line, true) {
            Some(rest) => out.push_str(&rest),
            None if line.trim().is_empty() || line.trim_start().starts_with("[,") => {}
            None => return None,
        }
        out.push('\n');
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_commas_are_told_from_commas_between_numbers() {
        let read =
            |text: &str| plain(text).map(|(text, notice)| (text.into_owned(), notice.is_some())).map_err(|e| e.to_string());
        for (text, points) in [
            ("1,5;2,5\n5,5;6\n", "1.5;2.5\n5.5;6\n"),
            ("10,5\t11,2\n1\t2,5\n3,5\t4\n", "10.5\t11.2\n1\t2.5\n3.5\t4\n"),
            ("\"1,5\";\"2,5\"\n\"3,5\";\"4,5\"\n", "\"1.5\";\"2.5\"\n\"3.5\";\"4.5\"\n"),
        ] {
            assert_eq!(read(text), Ok((points.into(), true)), "{text:?}");
        }
        for text in ["0,1;1,0", "0,1;\n1,0;\n", "0,1,0;1,0,0\n0,0,0;1,1,1\n", "0,1\n1,0\n", "0, 1, 1\n", "\"0\",\"1\"\n"] {
            assert_eq!(read(text), Ok((text.into(), false)), "{text:?}");
        }
        for text in ["10,5 11,2 12,3\n1,5 2,5 3,5\n", "\"1,200\",\"1,300\"\n", "\"1,5\",\"2,5\"\n"] {
            assert!(read(text).is_err(), "{text:?}");
        }
    }

    #[test]
    fn what_r_prints() {
        let printed = "     [,1] [,2] [,3]\n[1,]    0    0    1\n[2,]    0    1    0\n";
        assert_eq!(of_r(printed).as_deref(), Some("\n    0    0    1\n    0    1    0\n"));
        for text in ["0 1\n1 0\n", "[0,1]\n[1,0]\n", "[1,]\n", "[,1]\nx\n"] {
            assert_eq!(of_r(text), None, "{text:?}");
        }
    }
}
