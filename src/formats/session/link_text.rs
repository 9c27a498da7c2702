//! The link within whatever it has arrived in: the Rust of `www/src/share/link_in_text.ts`, which says what programs make of links.

/// Codes may have been made codes again.
const MOST_TIMES_CODED: usize = 3;
/// So many words behind a link are looked at.
const MOST_WORDS: usize = 200;

/// The words that the text of a session's link may be in; none where there is no link. Which of them belong to it, it knows itself.
pub(super) fn words_of_link(text: &str) -> Option<Vec<String>> {
    text.char_indices().find_map(|(at, _)| behind_head(&text[at..])).map(|behind| words(&plain(behind)))
}

/// What stands behind `#x=`, however its signs are written.
fn behind_head(text: &str) -> Option<&str> {
    let behind_hash =
        ["#", "&#35;", "=23"].iter().find_map(|sign| text.strip_prefix(sign)).or_else(|| behind_code(text, "23"))?;
    let behind_x = behind_hash.strip_prefix('x')?;
    let equals = ["=3D", "=", "&#61;"].iter().find_map(|sign| behind_x.strip_prefix(sign));
    equals.or_else(|| behind_code(behind_x, "3D")).or_else(|| behind_code(behind_x, "3d"))
}

/// What stands behind `%23`, `%2523` and so on.
fn behind_code<'a>(text: &'a str, code: &str) -> Option<&'a str> {
    text.strip_prefix('%')?.trim_start_matches("25").strip_prefix(code)
}

/// Signs for their codes, lines for those that mail has broken.
fn plain(text: &str) -> String {
    let mut now = text.replace("=\r\n", "").replace("=\n", "");
    for code in ["20", "2D", "5F", "0D", "0A", "09"] {
        now = now.replace(&format!("={code}"), &format!("%{code}"));
    }
    for _ in 0..MOST_TIMES_CODED {
        if now.contains('%') {
            now = decoded(&now);
        }
    }
    now.replace("&shy;", "").replace("&#8203;", "").replace("<wbr>", "").replace(is_unseen, "")
}

/// Codes that are no text stay as they are.
fn decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once('%') {
        bytes.extend(before.as_bytes());
        match behind.get(..2).and_then(|code| u8::from_str_radix(code, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &behind[2..];
            }
            None => {
                bytes.push(b'%');
                rest = behind;
            }
        }
    }
    bytes.extend(rest.as_bytes());
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Zero width, soft hyphens, and marks of direction.
fn is_unseen(sign: char) -> bool {
    matches!(sign, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}')
}

/// Up to the first sign that is neither a link's, nor between words, nor what quotes a line of mail.
fn words(text: &str) -> Vec<String> {
    let is_letter = |sign: char| sign.is_ascii_alphanumeric() || sign == '-' || sign == '_';
    let mut words = Vec::new();
    let mut rest = text.trim_start();
    while words.len() < MOST_WORDS {
        let end = rest.find(|sign| !is_letter(sign)).unwrap_or(rest.len());
        if end == 0 {
            break;
        }
        words.push(rest[..end].to_owned());
        rest = &rest[end..];
        if !rest.starts_with(char::is_whitespace) {
            break;
        }
        rest = rest.trim_start_matches(|sign: char| sign.is_whitespace() || sign == '>' || sign == '|');
    }
    words
}
