//! Typed parameters: one `params!` row is the only place where a parameter is described.
//!
//! From a row follow the struct field, its default, validation with the error that names the range, the JSON schema of the catalog,
//! the command line's `--set key=value`, the page's control and the tables in the docs.
//!
//! ```
//! use formicarium::params;
//! use formicarium::params::{Params, Value};
//!
//! params! {
//!     /// Numbers of a planner.
//!     pub struct Numbers {
//!         /// ants that build a path in each iteration
//!         ants: u32 = 50, "m", [1..=1024], "ants", "here";
//!     }
//! }
//!
//! let numbers = Numbers::read("mine", &[("ants".to_string(), Value::from(9.0))].into())?;
//! assert_eq!(numbers.ants, 9);
//! assert!(Numbers::read("mine", &[("ants".to_string(), Value::from(0.0))].into()).is_err(), "out of range");
//! # Ok::<(), formicarium::error::ParamError>(())
//! ```

use std::collections::BTreeMap;
use std::fmt;
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use crate::error::ParamError;

/// A parameter's value as it crosses boundaries.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Value {
    /// `true` or `false`.
    Flag(bool),
    /// An integer or real number.
    Number(f64),
    /// The id of a choice.
    Text(String),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag(v) => v.fmt(f),
            Self::Number(v) => v.fmt(f),
            Self::Text(v) => v.fmt(f),
        }
    }
}

impl Value {
    /// Reads a command line's text: a number, `true`, `false`, or the id of a choice.
    pub fn parse(text: &str) -> Self {
        match (text.parse::<f64>(), text.parse::<bool>()) {
            (Ok(v), _) => Self::Number(v),
            (_, Ok(v)) => Self::Flag(v),
            _ => Self::Text(text.into()),
        }
    }
}

impl From<bool> for Value {
    fn from(v: bool) -> Self {
        Self::Flag(v)
    }
}

impl From<f64> for Value {
    fn from(v: f64) -> Self {
        Self::Number(v)
    }
}

impl From<&str> for Value {
    fn from(v: &str) -> Self {
        Self::Text(v.into())
    }
}

/// Values by key; what is absent takes its default.
pub type Values = BTreeMap<String, Value>;

/// One option of a choice.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ChoiceOption {
    /// Its id, as it stands in links and files.
    pub id: &'static str,
    /// What it does.
    pub meaning: &'static str,
}

/// What values a parameter takes.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ParamKind {
    /// A whole number in `min..=max`.
    Integer {
        /// Smallest allowed.
        min: f64,
        /// Largest allowed.
        max: f64,
    },
    /// A real number in `min..=max`.
    Real {
        /// Smallest allowed.
        min: f64,
        /// Largest allowed.
        max: f64,
    },
    /// Yes or no.
    Flag,
    /// One of several ids.
    Choice {
        /// The options, the usual one first.
        options: Vec<ChoiceOption>,
    },
}

/// When a parameter has an effect.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AppliesWhen {
    /// The other parameter …
    pub key: &'static str,
    /// … has one of these values.
    pub values: Vec<Value>,
}

/// Everything about one parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct ParamSpec {
    /// Stable key in links, files and on the command line.
    pub key: &'static str,
    /// The symbol of the literature, e.g. ρ.
    pub symbol: &'static str,
    /// Type and range.
    pub kind: ParamKind,
    /// Value when none is given.
    pub default: Value,
    /// Unit; empty for a pure number.
    pub unit: &'static str,
    /// What it does.
    pub meaning: &'static str,
    /// Where the definition or the default comes from.
    pub source: &'static str,
    /// None when it always has an effect.
    pub applies_when: Option<AppliesWhen>,
}

impl ParamSpec {
    fn wrong_type(&self, value: &Value, expected: impl Into<String>) -> ParamError {
        ParamError::WrongType {
            key: self.key.into(),
            value: value.to_string(),
            expected: expected.into(),
            meaning: self.meaning.into(),
        }
    }

    /// Whether a value fits.
    ///
    /// # Errors
    /// [`ParamError`] with key, value and what is allowed.
    pub fn check(&self, value: &Value) -> Result<(), ParamError> {
        match (&self.kind, value) {
            (ParamKind::Integer { .. } | ParamKind::Real { .. }, _) => self.number(value).map(drop),
            (ParamKind::Flag, _) => bool::read(self, value).map(drop),
            (ParamKind::Choice { options }, Value::Text(id)) if options.iter().any(|o| o.id == id) => Ok(()),
            (ParamKind::Choice { options }, _) => Err(self.wrong_type(value, one_of(options.iter().map(|o| o.id)))),
        }
    }

    /// The number in a value, checked against type and range.
    fn number(&self, value: &Value) -> Result<f64, ParamError> {
        let (min, max, whole) = match self.kind {
            ParamKind::Integer { min, max } => (min, max, true),
            ParamKind::Real { min, max } => (min, max, false),
            _ => return Err(self.wrong_type(value, "a number")),
        };
        let &Value::Number(v) = value else { return Err(self.wrong_type(value, "a number")) };
        if !(min..=max).contains(&v) {
            let (key, meaning) = (self.key.into(), self.meaning.into());
            return Err(ParamError::OutOfRange { key, value: value.to_string(), min, max, meaning });
        }
        if whole && v.fract() != 0.0 { Err(self.wrong_type(value, "a whole number")) } else { Ok(v) }
    }
}

/// What stands for a choice in an error.
fn one_of(ids: impl Iterator<Item = &'static str>) -> String {
    format!("one of {}", ids.collect::<Vec<_>>().join(", "))
}

/// A type that a parameter can have.
pub trait ParamType: Copy {
    /// What limits it.
    type Range;
    /// Type and range for the catalog.
    fn kind(range: Self::Range) -> ParamKind;
    /// Reads and checks a value.
    ///
    /// # Errors
    /// [`ParamError`] with key, value and what is allowed.
    fn read(spec: &ParamSpec, value: &Value) -> Result<Self, ParamError>;
    /// The value that [`ParamType::read`] turns back into `self`.
    fn value(self) -> Value;
}

impl ParamType for u32 {
    type Range = RangeInclusive<u32>;
    fn kind(range: Self::Range) -> ParamKind {
        ParamKind::Integer { min: f64::from(*range.start()), max: f64::from(*range.end()) }
    }
    fn read(spec: &ParamSpec, value: &Value) -> Result<Self, ParamError> {
        spec.number(value).map(|v| v as u32)
    }
    fn value(self) -> Value {
        Value::Number(f64::from(self))
    }
}

impl ParamType for f64 {
    type Range = RangeInclusive<f64>;
    fn kind(range: Self::Range) -> ParamKind {
        ParamKind::Real { min: *range.start(), max: *range.end() }
    }
    fn read(spec: &ParamSpec, value: &Value) -> Result<Self, ParamError> {
        spec.number(value)
    }
    fn value(self) -> Value {
        Value::Number(self)
    }
}

impl ParamType for bool {
    type Range = ();
    fn kind((): ()) -> ParamKind {
        ParamKind::Flag
    }
    fn read(spec: &ParamSpec, value: &Value) -> Result<Self, ParamError> {
        match value {
            Value::Flag(v) => Ok(*v),
            _ => Err(spec.wrong_type(value, "true or false")),
        }
    }
    fn value(self) -> Value {
        Value::Flag(self)
    }
}

/// An enum whose variants have ids; made by [`param_choice!`](crate::param_choice).
pub trait ParamChoice: Copy + PartialEq + 'static {
    /// (variant, id, meaning) of every option, the usual one first.
    const OPTIONS: &'static [(Self, &'static str, &'static str)];
}

impl<T: ParamChoice> ParamType for T {
    type Range = ();
    fn kind((): ()) -> ParamKind {
        let option = |&(_, id, meaning): &(T, &'static str, &'static str)| ChoiceOption { id, meaning: meaning.trim() };
        ParamKind::Choice { options: T::OPTIONS.iter().map(option).collect() }
    }
    fn read(spec: &ParamSpec, value: &Value) -> Result<Self, ParamError> {
        let found = T::OPTIONS.iter().find(|o| matches!(value, Value::Text(id) if id == o.1));
        found.map(|o| o.0).ok_or_else(|| spec.wrong_type(value, one_of(T::OPTIONS.iter().map(|o| o.1))))
    }
    fn value(self) -> Value {
        let id = T::OPTIONS.iter().find(|o| o.0 == self).map_or("", |o| o.1);
        Value::Text(id.into())
    }
}

/// A planner's parameter set; made by `params!`.
pub trait Params: Sized + Default {
    /// All rows, in the order in which people should meet them.
    fn specs() -> Vec<ParamSpec>;
    /// Reads the values of its own rows over `defaults`; other keys are somebody else's.
    ///
    /// # Errors
    /// [`ParamError`] for a wrong type, or a value outside its range.
    fn pick(values: &Values, defaults: Self) -> Result<Self, ParamError>;
    /// Reads values over the defaults.
    ///
    /// # Errors
    /// [`ParamError`] for an unknown key, a wrong type, or a value outside its range.
    fn read(planner: &str, values: &Values) -> Result<Self, ParamError> {
        check_keys(planner, &Self::specs(), values)?;
        Self::pick(values, Self::default())
    }
}

/// Refuses keys that no row describes.
///
/// # Errors
/// [`ParamError::UnknownKey`] for the first such key.
pub fn check_keys(planner: &str, specs: &[ParamSpec], values: &Values) -> Result<(), ParamError> {
    match values.keys().find(|k| specs.iter().all(|s| s.key != k.as_str())) {
        None => Ok(()),
        Some(key) => {
            let known = specs.iter().map(|s| s.key).collect::<Vec<_>>().join(", ");
            Err(ParamError::UnknownKey { planner: planner.into(), key: key.clone(), known })
        }
    }
}

/// The value of one row: what is given, or the default.
///
/// # Errors
/// [`ParamError`] when the given value does not fit.
pub fn read_one<T: ParamType>(specs: &[ParamSpec], key: &str, values: &Values, default: T) -> Result<T, ParamError> {
    let Some(value) = values.get(key) else { return Ok(default) };
    let Some(spec) = specs.iter().find(|s| s.key == key) else { return Ok(default) };
    T::read(spec, value)
}

/// Gives a shared row another default, with its source.
pub fn override_row(rows: &mut [ParamSpec], key: &str, default: Value, source: &'static str) {
    for row in rows.iter_mut().filter(|r| r.key == key) {
        row.default = default.clone();
        row.source = source;
    }
}

/// Declares a [`ParamChoice`]: `Variant = "id"`, the doc comment is the option's meaning.
#[macro_export]
macro_rules! param_choice {
    ($(#[$meta:meta])* pub enum $name:ident { $( #[doc = $meaning:literal] $variant:ident = $id:literal, )+ }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name { $( #[doc = $meaning] $variant, )+ }
        impl $crate::params::ParamChoice for $name {
            const OPTIONS: &'static [(Self, &'static str, &'static str)] = &[ $( (Self::$variant, $id, $meaning), )+ ];
        }
    };
}

/// Declares a parameter set. A row: doc comment = meaning; `key: type = default, "symbol", [range], "unit", "source", when(key: values)`.
/// `..field: Set;` after a row takes in the rows of another set at that place, as a field; `..field: Set { key = default, "source"; };`
/// gives some of them another default.
#[macro_export]
macro_rules! params {
    ($(#[$meta:meta])* pub struct $name:ident {
        $(
            #[doc = $meaning:literal]
            $key:ident : $type:ty = $default:expr, $symbol:literal, [$($range:expr)?], $unit:literal, $source:literal
                $(, when($when:ident : $($value:literal)|+))? ;
        )+
        $(
            ..$shared:ident : $set:ty $({ $( $other:ident = $instead:expr, $reason:literal ; )+ })? ;
            $(
                #[doc = $meaning2:literal]
                $key2:ident : $type2:ty = $default2:expr, $symbol2:literal, [$($range2:expr)?], $unit2:literal, $source2:literal
                    $(, when($when2:ident : $($value2:literal)|+))? ;
            )*
        )*
    }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $name {
            $( #[doc = $meaning] pub $key: $type, )+
            $(
                #[doc = concat!("Shared rows: [`", stringify!($set), "`].")]
                pub $shared: $set,
                $( #[doc = $meaning2] pub $key2: $type2, )*
            )*
        }
        impl Default for $name {
            fn default() -> Self {
                Self {
                    $( $key: $default, )+
                    $(
                        $shared: $crate::params!(@set $set, $($( $other = $instead, )+)?),
                        $( $key2: $default2, )*
                    )*
                }
            }
        }
        impl $crate::params::Params for $name {
            fn specs() -> Vec<$crate::params::ParamSpec> {
                [
                    vec![ $( $crate::params!(
                        @spec $meaning, $key, $type, $default, $symbol, ($($range)?), $unit, $source, $($when $($value)+)?
                    ), )+ ],
                    $(
                        {
                            #[allow(unused_mut, reason = "most sets are taken in as they are")]
                            let mut rows = <$set as $crate::params::Params>::specs();
                            $($(
                                let default = $crate::params::ParamType::value(Self::default().$shared.$other);
                                $crate::params::override_row(&mut rows, stringify!($other), default, $reason);
                            )+)?
                            rows
                        },
                        vec![ $( $crate::params!(
                            @spec $meaning2, $key2, $type2, $default2, $symbol2, ($($range2)?), $unit2, $source2, $($when2 $($value2)+)?
                        ), )* ],
                    )*
                ]
                .concat()
            }
            fn pick(values: &$crate::params::Values, default: Self) -> Result<Self, $crate::error::ParamError> {
                let specs = Self::specs();
                Ok(Self {
                    $( $key: $crate::params::read_one(&specs, stringify!($key), values, default.$key)?, )+
                    $(
                        $shared: <$set as $crate::params::Params>::pick(values, default.$shared)?,
                        $( $key2: $crate::params::read_one(&specs, stringify!($key2), values, default.$key2)?, )*
                    )*
                })
            }
        }
    };
    (@spec $meaning:literal, $key:ident, $type:ty, $default:expr, $symbol:literal, $range:expr, $unit:literal, $source:literal, $($when:tt)*) => {
        $crate::params::ParamSpec {
            key: stringify!($key).into(),
            symbol: $symbol.into(),
            kind: <$type as $crate::params::ParamType>::kind($range),
            default: <$type as $crate::params::ParamType>::value($default),
            unit: $unit.into(),
            meaning: $meaning.trim().into(),
            source: $source.into(),
            applies_when: $crate::params!(@when $($when)*),
        }
    };
    (@set $set:ty,) => { <$set>::default() };
    (@set $set:ty, $( $other:ident = $instead:expr, )+) => { {
        let mut set = <$set>::default();
        $( set.$other = $instead; )+
        set
    } };
    (@when) => { None };
    (@when $key:ident $($value:literal)+) => {
        Some($crate::params::AppliesWhen {
            key: stringify!($key).into(),
            values: vec![ $( $crate::params::Value::from($value) ),+ ],
        })
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    params! {
        /// Shared.
        pub struct Shared {
            /// how many
            count: u32 = 3, "n", [1..=9], "", "somewhere";
            /// how much
            share: f64 = 0.5, "s", [0.0..=1.0], "", "somewhere";
        }
    }

    params! {
        /// Own.
        pub struct Own {
            /// whether
            on: bool = true, "", [], "", "here";
            ..shared: Shared { share = 0.25, "here"; };
        }
    }

    #[test]
    fn a_shared_row_may_have_another_default() {
        assert_eq!((Own::default().shared.count, Own::default().shared.share), (3, 0.25));
        let rows = Own::specs();
        assert_eq!(rows.iter().map(|r| r.key).collect::<Vec<_>>(), ["on", "count", "share"]);
        assert_eq!((&rows[2].default, rows[2].source, rows[1].source), (&Value::Number(0.25), "here", "somewhere"));
        let own = Own::read("own", &[("count".to_string(), Value::Number(7.0))].into()).expect("valid");
        assert_eq!((own.on, own.shared.count, own.shared.share), (true, 7, 0.25));
        assert!(Own::read("own", &[("share".to_string(), Value::Number(2.0))].into()).is_err());
    }
}
