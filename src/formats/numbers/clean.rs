//! Texts without their comments.

use super::super::text::lines;

/// What is open at the end of a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Open {
    Nothing,
    /// `%{` of MATLAB: how deep.
    Matlab(u32),
    /// `/*` of C.
    C,
    /// Three quotation marks of Python.
    Quotes(&'static str),
}

/// A text without comments: `%`, `#`, `//` to the end of the line, what follows a `...`, and the blocks `%{ %}`, `/* */`, `""" """`,
/// `''' '''`. Lines stay where they are and end with LF; the `...` stays.
pub(super) fn without_comments(text: &str) -> String {
    let mut clean = String::with_capacity(text.len() + 1);
    let mut open = Open::Nothing;
    for (_, line) in lines(text) {
        open = line_without(line, open, &mut clean);
        clean.push('\n');
    }
    clean
}

fn line_without(line: &str, mut open: Open, clean: &mut String) -> Open {
    let mut rest = line;
    loop {
        open = match (open, rest.trim()) {
            (Open::Nothing, "%{" | "#{") => return Open::Matlab(1),
            (Open::Matlab(deep), "%{" | "#{") => return Open::Matlab(deep + 1),
            (Open::Matlab(1), "%}" | "#}") => return Open::Nothing,
            (Open::Matlab(deep), "%}" | "#}") => return Open::Matlab(deep - 1),
            (Open::Matlab(_), _) => return open,
            (Open::C, _) => match rest.split_once("*/") {
                None => return open,
                Some((_, after)) => {
                    rest = after;
                    Open::Nothing
                }
            },
            (Open::Quotes(mark), _) => match rest.split_once(mark) {
                None => return open,
                Some((_, after)) => {
                    rest = after;
                    Open::Nothing
                }
            },
            (Open::Nothing, _) => {
                let Some((kept, mark, after)) = first_mark(rest) else {
                    clean.push_str(rest);
                    return open;
                };
                clean.push_str(kept);
                rest = after;
                match mark {
                    "/*" => Open::C,
                    "\"\"\"" | "'''" => Open::Quotes(mark),
                    "..." => {
                        clean.push_str(mark);
                        return open;
                    }
                    _ => return open,
                }
            }
        };
    }
}

/// What stands before the first mark of a comment, the mark, and what stands behind it.
fn first_mark(line: &str) -> Option<(&str, &'static str, &str)> {
    const MARKS: [&str; 7] = ["/*", "//", "\"\"\"", "'''", "...", "%", "#"];
    // Nearly all lines of a map have none.
    let from = line.bytes().position(|b| b"/\"'.%#".contains(&b))?;
    let begins = |at: usize| MARKS.into_iter().find(|mark| line.as_bytes()[at..].starts_with(mark.as_bytes()));
    let (at, mark) = (from..line.len()).filter_map(|at| Some((at, begins(at)?))).find(|&(at, mark)| is_meant(line, at, mark))?;
    Some((&line[..at], mark, &line[at + mark.len()..]))
}

/// Whether a sign begins a comment, or with `...` a row goes on: not where a spreadsheet or a printer of arrays means something else.
fn is_meant(line: &str, at: usize, mark: &str) -> bool {
    let (before, after) = (&line[..at], &line[at + mark.len()..]);
    match mark {
        // Numbers that were left out: `[0, 0, ..., 1]`, or a line of its own.
        "..." => {
            !before.trim().is_empty()
                && !before.trim_end().ends_with('[')
                && !after.trim_start().starts_with([',', ';', ']', '}'])
                && !begins_number(after)
        }
        // `#N/A`, `#DIV/0!`
        "#" => !["N/A", "REF!", "DIV/0!", "NAME?", "VALUE!", "NUM!", "NULL!"].iter().any(|word| after.starts_with(word)),
        // `50%`, `1//2`
        "%" | "//" => {
            !before.ends_with(|c: char| c.is_ascii_digit())
                || !(after.is_empty() || after.starts_with([',', ';', '\t']) || begins_number(after))
        }
        _ => true,
    }
}

fn begins_number(text: &str) -> bool {
    text.trim_start().starts_with(|c: char| c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_of_every_language_go_and_lines_stay() {
        for (text, clean) in [
            ("a % b\nc", "a \nc\n"),
            ("%{\nG=[1]\n%}\nG=[0]", "\n\n\nG=[0]\n"),
            ("%{\n%{\nx\n%}\ny\n%}\nz", "\n\n\n\n\n\nz\n"),
            ("a /* b */ c // d\ne", "a  c \ne\n"),
            ("/* a\nb */ c", "\n c\n"),
            ("\"\"\"doc\n[[0,1]]\n\"\"\"\nx = 1", "\n\n\nx = 1\n"),
            ("'''one''' 2", " 2\n"),
            ("1 ... rest\n2", "1 ...\n2\n"),
            ("x %{ y\nz", "x \nz\n"),
            ("0.5,.5,1.", "0.5,.5,1.\n"),
        ] {
            assert_eq!(without_comments(text), clean, "{text:?}");
        }
    }
}
