//! Texts that people wrote, as Markdown takes them: no HTML, no broken rows, one line each.

use std::borrow::Cow;

/// A text in a paragraph, a heading or a list: no HTML begins, no block of code, and no line ends. None begins with `< `, as in `< 0.1 %`.
pub(super) fn prose(text: &str) -> Cow<'_, str> {
    let opens_code = |text: &str| text.starts_with("```") || text.starts_with("~~~");
    if opens_code(text.trim_start()) {
        return Cow::Owned(format!("\\{}", prose_within(text.trim_start())));
    }
    prose_within(text)
}

fn prose_within(text: &str) -> Cow<'_, str> {
    let has_meaning = |c: char| c == '<' || c.is_control();
    if !text.contains(has_meaning) {
        return Cow::Borrowed(text);
    }
    let is_before_space = |at: usize| text[at..].starts_with("< ");
    let letter = |(at, letter): (usize, char)| if is_before_space(at) { letter.to_string() } else { plain(letter) };
    Cow::Owned(text.char_indices().map(letter).collect())
}

/// A text in a cell of a table: no column begins either.
pub(super) fn cell(text: &str) -> Cow<'_, str> {
    let prose = prose(text);
    if prose.contains('|') { Cow::Owned(prose.replace("\\|", "\\\\|").replace('|', "\\|")) } else { prose }
}

fn plain(letter: char) -> String {
    match letter {
        '<' => "&lt;".into(),
        _ if letter.is_control() => " ".into(),
        _ => letter.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_breaks_out() {
        assert_eq!(prose("|h| < 3\n\u{1b}[2J <script>"), "|h| < 3  [2J &lt;script>");
        assert_eq!(cell("a|b\r\n| c"), "a\\|b  \\| c");
        // A backslash of the text does not undo ours.
        assert_eq!(cell("a \\| b"), "a \\\\\\| b");
        assert_eq!([prose("```js\nx"), prose(" ~~~")], ["\\```js x", "\\~~~"]);
        assert!(matches!(cell("ants, ρ = 0.1 & `more`"), Cow::Borrowed(_)));
    }
}
