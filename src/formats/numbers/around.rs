//! What a program does with a matrix beside writing it down: it may turn, negate or change it, and nothing of that is computed here.

use std::ops::Range;

use super::super::text::quote;
use crate::error::Notice;

/// Functions that only make a matrix of its rows.
const MAKERS: [&str; 18] = [
    "array", "asarray", "matrix", "Matrix", "Array", "tensor", "list", "tuple", "int8", "uint8", "int32", "double", "single",
    "logical", "float", "int", "mat", "from",
];

/// Says what is done with a matrix that stands at `span` and is assigned to `name`; none where it is used as it stands.
pub(super) fn computed(text: &str, span: &Range<usize>, name: &str) -> Option<Notice> {
    let sign = behind(&text[span.end..]).or_else(|| before(&text[..span.start])).or_else(|| changed(&text[span.end..], name))?;
    let message = format!("the program computes with it (`{sign}`): it was read as it stands");
    Some(Notice::new("matrix-computed", message).with("sign", sign))
}

/// A sign of computing right behind a matrix: a transposition, a subscript, an operator.
fn behind(after: &str) -> Option<String> {
    let rest = after.trim_start_matches([' ', ')']);
    let word = rest.split(|c: char| !(c.is_alphanumeric() || c == '.' || c == '_')).next().unwrap_or("");
    if [".T", ".t", ".transpose", ".reshape"].contains(&word) {
        return Some(word.into());
    }
    let sign = rest.chars().next()?;
    let is_transposed = sign == '\'' || rest.starts_with(".'");
    (is_transposed || "[+-*/^~".contains(sign) && !rest.starts_with("//") && !rest.starts_with("/*"))
        .then(|| quote(&rest[..sign.len_utf8()]))
}

/// An operator or a function before a matrix that does more than to make it.
fn before(text: &str) -> Option<String> {
    let trimmed = text.trim_end_matches([' ', '(', '[', '{']);
    let last = trimmed.chars().next_back()?;
    if "-~!+*/^".contains(last) {
        return Some(last.to_string());
    }
    if trimmed.len() == text.trim_end_matches(' ').len() {
        return None;
    }
    let from = trimmed.rfind(|c: char| !(c.is_alphanumeric() || c == '_')).map_or(0, |at| at + 1);
    let function = trimmed.get(from..).unwrap_or("");
    let is_function = function.starts_with(char::is_alphabetic) && text[trimmed.len()..].starts_with('(');
    (is_function && !MAKERS.contains(&function)).then(|| quote(function))
}

/// A later line that assigns to the matrix or to one of its cells.
fn changed(after: &str, name: &str) -> Option<String> {
    if name.is_empty() {
        return None;
    }
    after.split(['\n', ';']).skip(1).map(str::trim).find_map(|line| {
        let rest = line.strip_prefix(name)?;
        let target = match rest.chars().next()? {
            '(' | '[' => rest.split_once(['=', '\n'])?.0,
            ' ' | '=' | '+' | '-' | '*' | '^' | '~' => "",
            _ => return None,
        };
        let (_, value) = rest.split_once('=')?;
        let is_closed = target.is_empty() || target.trim_end().ends_with([')', ']']);
        (is_closed && !value.starts_with('=')).then(|| line.chars().take(40).collect())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sign(text: &str) -> Option<String> {
        let from = text.find("[0").expect("a matrix");
        let end = text.find("0]").expect("its end") + 2;
        computed(text, &(from..end), "G").map(|notice| notice.args["sign"].clone())
    }

    #[test]
    fn what_is_done_with_a_matrix_is_told() {
        for (text, told) in [
            ("G = [0 1; 1 0]';", "'"),
            ("G = 1-[0 1; 1 0];", "-"),
            ("G = ~[0 1; 1 0];", "~"),
            ("G = flipud([0 1; 1 0]);", "flipud"),
            ("G = np.array([0, 0]).T", ".T"),
            ("G = np.array([0, 0])[::-1]", "["),
            ("G = [0 1; 1 0];\nG=~G;", "G=~G"),
            ("G = [0 1; 1 0];\nx = 1;\nG(1,2) = 1;", "G(1,2) = 1"),
            ("G = [0, 0]\nG[0][1] = 1\n", "G[0][1] = 1"),
            ("G = [0, 0]\nG = rot90(G, 3)\n", "G = rot90(G, 3)"),
        ] {
            assert_eq!(sign(text).as_deref(), Some(told), "{text:?}");
        }
        for text in [
            "G = [0 1; 1 0];",
            "G = np.array([0, 0])",
            "G = double([0 0]);",
            "int G[1][2] = {[0, 0]};",
            "G = [0 0];\nif G(1,2) == 1, end\nGx = 3;\ny = G(1);",
            "G = [0, 0]  // rows",
        ] {
            assert_eq!(sign(text), None, "{text:?}");
        }
    }
}
