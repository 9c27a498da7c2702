//! YAML, and with it JSON, as a small tree: lists of plain numbers stay lists of numbers, since a map has millions of them.

use std::borrow::Cow;

use saphyr_parser::{Event, Parser, Span};

use crate::error::FormatError;
use crate::formats::text::{lines, quote};

/// Deepest nesting that is read.
const DEEPEST: usize = 32;

/// Numbers of a list that are kept with all their digits; occupancies need few.
const FEW: usize = 4096;

/// A value of a document.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// Anything that is neither a list nor a map.
    Text(String),
    /// A list of numbers.
    Numbers(Vec<f64>),
    /// A list of more than [`FEW`] numbers.
    Many(Vec<f32>),
    /// A list of anything else.
    List(Vec<Value>),
    /// Keys with their values, in order.
    Map(Vec<(String, Value)>),
}

/// The first document of a text. Anchors are refused, since a few of them can stand for any amount of text.
///
/// # Errors
/// [`FormatError::Syntax`] with the line.
pub(super) fn read(text: &str) -> Result<Value, FormatError> {
    let mut events = Events { parser: Parser::new_from_str(text) };
    loop {
        let (event, line) = events.next()?;
        match event {
            Event::StreamStart | Event::DocumentStart(_) | Event::Nothing => {}
            Event::StreamEnd => return Err(FormatError::syntax(line, "the text holds no value", "`key: value` lines")),
            event => return events.value(event, line, DEEPEST),
        }
    }
}

/// Whether another document follows the first one.
pub(super) fn holds_more(text: &str) -> bool {
    let mut said = lines(text).map(|(_, line)| line).filter(|line| !line.trim().is_empty() && !line.starts_with(['#', '%']));
    let is_mark = |line: &str| matches!(line.trim_end(), "---" | "...");
    said.by_ref().find(|line| !is_mark(line));
    said.by_ref().any(is_mark) && said.any(|line| !is_mark(line))
}

struct Events<'a> {
    parser: Parser<'a, saphyr_parser::StrInput<'a>>,
}

impl<'a> Events<'a> {
    fn next(&mut self) -> Result<(Event<'a>, usize), FormatError> {
        match self.parser.next() {
            Some(Ok((event, Span { start, .. }))) => Ok((event, start.line())),
            Some(Err(error)) => {
                let line = error.marker().line();
                Err(FormatError::syntax(line, format!("this is no YAML: {}", quote(error.info())), "`key: value` lines"))
            }
            None => Ok((Event::StreamEnd, 0)),
        }
    }

    fn value(&mut self, event: Event<'a>, line: usize, depth: usize) -> Result<Value, FormatError> {
        let anchored = matches!(event, Event::Alias(_))
            || matches!(event, Event::Scalar(_, _, id, _) | Event::SequenceStart(id, _) | Event::MappingStart(id, _) if id > 0);
        if anchored || depth == 0 {
            let what = if anchored { "anchors (& and *) are not read" } else { "lists within lists go too deep" };
            return Err(FormatError::syntax(line, what, "the values themselves"));
        }
        match event {
            Event::Scalar(text, ..) => Ok(Value::Text(text.into_owned())),
            Event::SequenceStart(..) => self.list(depth - 1),
            Event::MappingStart(..) => self.map(depth - 1),
            _ => Err(FormatError::syntax(line, "the text ends too soon", "a value")),
        }
    }

    fn list(&mut self, depth: usize) -> Result<Value, FormatError> {
        let mut values = Value::Numbers(Vec::new());
        loop {
            let (event, line) = self.next()?;
            if matches!(event, Event::SequenceEnd) {
                return Ok(values);
            }
            let number = match &event {
                Event::Scalar(text, _, 0, _) => text.parse::<f64>().ok(),
                _ => None,
            };
            match (&mut values, number) {
                (Value::Numbers(few), Some(number)) if few.len() < FEW => few.push(number),
                (Value::Numbers(few), Some(number)) => {
                    let many = few.iter().chain([&number]).map(|&number| number as f32).collect();
                    values = Value::Many(many);
                }
                (Value::Many(many), Some(number)) => many.push(number as f32),
                (Value::List(list), _) => list.push(self.value(event, line, depth)?),
                // No list of numbers after all.
                (before, None) => {
                    let mut list: Vec<Value> = before.many().iter().map(|number| Value::Text(number.to_string())).collect();
                    list.push(self.value(event, line, depth)?);
                    values = Value::List(list);
                }
                (_, Some(_)) => {}
            }
        }
    }

    fn map(&mut self, depth: usize) -> Result<Value, FormatError> {
        let mut entries = Vec::new();
        loop {
            let (event, line) = self.next()?;
            match event {
                Event::MappingEnd => return Ok(Value::Map(entries)),
                Event::Scalar(key, ..) => {
                    if entries.iter().any(|(known, _)| *known == key) {
                        return Err(FormatError::syntax(line, format!("`{}` stands twice", quote(&key)), "each key once"));
                    }
                    let (event, line) = self.next()?;
                    let value = self.value(event, line, depth)?;
                    entries.push((key.into_owned(), value));
                }
                _ => return Err(FormatError::syntax(line, "a key is no plain text", "`key: value` lines")),
            }
        }
    }
}

impl Value {
    /// The value behind a path of keys.
    pub fn get(&self, path: &[&str]) -> Option<&Self> {
        path.iter().try_fold(self, |value, wanted| match value {
            Self::Map(entries) => entries.iter().find(|(key, _)| key == wanted).map(|(_, value)| value),
            _ => None,
        })
    }

    /// The text of a value; none for lists and maps.
    pub fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self { Some(text) } else { None }
    }

    /// The finite number that a value is.
    pub fn number(&self) -> Option<f64> {
        self.text()?.trim().parse().ok().filter(|v: &f64| v.is_finite())
    }

    /// The numbers of a short list; none for anything else.
    pub fn numbers(&self) -> Option<&[f64]> {
        if let Self::Numbers(numbers) = self { Some(numbers) } else { None }
    }

    /// The numbers of any list of numbers; empty for anything else.
    pub fn many(&self) -> Cow<'_, [f32]> {
        match self {
            Self::Many(many) => Cow::Borrowed(many),
            Self::Numbers(few) => few.iter().map(|&number| number as f32).collect(),
            _ => Cow::Borrowed(&[]),
        }
    }

    /// The values of a list of lists or maps.
    pub fn list(&self) -> Option<&[Self]> {
        match self {
            Self::List(values) => Some(values),
            Self::Numbers(numbers) if numbers.is_empty() => Some(&[]),
            _ => None,
        }
    }
}

/// A number that must be there.
///
/// # Errors
/// [`FormatError::Field`].
pub(super) fn required(document: &Value, path: &[&str], field: &'static str, expected: &str) -> Result<f64, FormatError> {
    let Some(value) = document.get(path) else { return Err(FormatError::field(field, "missing", expected)) };
    value.number().ok_or_else(|| FormatError::field(field, format!("`{}`", quote(value.text().unwrap_or("a list"))), expected))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn yaml_and_json_are_one() {
        for text in
            ["a: 1\nb: [1, -2.5]\nc:\n- x\n- [1]\nd: {e: f}\n", r#"{"a": 1, "b": [1, -2.5], "c": ["x", [1]], "d": {"e": "f"}}"#]
        {
            let document = read(text).unwrap();
            assert_eq!(document.get(&["a"]).and_then(Value::number), Some(1.0), "{text}");
            assert_eq!(document.get(&["b"]).and_then(Value::numbers), Some(&[1.0, -2.5][..]));
            assert_eq!(document.get(&["c"]).and_then(Value::list).map(<[_]>::len), Some(2));
            assert_eq!(document.get(&["d", "e"]).and_then(Value::text), Some("f"));
        }
    }

    #[test]
    fn what_could_grow_without_end_is_refused() {
        for text in ["a: &x [1]\nb: [*x, *x]\n", &"[".repeat(100), "a: 1\na: 2\n", "", "a: [1", "? [1]\n: 2\n"] {
            assert!(read(text).is_err(), "{text:?}");
        }
    }
}
