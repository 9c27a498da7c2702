//! What a script passes, under the types of the package. JavaScript checks none of them, so nothing is taken for what its type says before it
//! has been looked at: what is not throws `bad-argument` with the parameter's name, and leaves the instance as it was.
//!
//! Each crosses as a bare JS value. Where wasm-bindgen converts by itself, a number in the place of an array would be an address, and 2³² a 0.

use js_sys::{Array, ArrayBuffer, Float32Array, JSON, Reflect, Uint8Array};
use serde::de::value::StringDeserializer;
use serde::de::{DeserializeOwned, IntoDeserializer};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

use super::{Answer, plain};
use crate::error::ErrorReport;
use crate::params::{Value, Values};

#[wasm_bindgen]
extern "C" {
    /// A text.
    #[wasm_bindgen(typescript_type = "string")]
    pub type Text;
    /// A number.
    #[wasm_bindgen(typescript_type = "number")]
    pub type Number;
    /// True or false.
    #[wasm_bindgen(typescript_type = "boolean")]
    pub type Flag;
    /// A file, or one byte a cell.
    #[wasm_bindgen(typescript_type = "Uint8Array | number[]")]
    pub type Bytes;
    /// One height a cell, NaN for no data.
    #[wasm_bindgen(typescript_type = "Float32Array | number[]")]
    pub type Heights;
    /// Parameter values by key.
    #[wasm_bindgen(typescript_type = "ParamInput")]
    pub type ParamValues;
    /// What a map is painted on.
    #[wasm_bindgen(typescript_type = "OffscreenCanvasRenderingContext2D")]
    pub type Context;
    /// Which colours.
    #[wasm_bindgen(typescript_type = "'light' | 'dark'")]
    pub type ThemeName;
    /// Tells seconds.
    #[wasm_bindgen(typescript_type = "Function")]
    pub type Clock;
    /// One time an improvement, and one for the end.
    #[wasm_bindgen(typescript_type = "Float64Array | number[]")]
    pub type Seconds;
    /// What is painted over a map.
    #[wasm_bindgen(typescript_type = "Layer | 'none'")]
    pub type LayerOrNone;
}

impl Text {
    /// The text; half a surrogate pair becomes U+FFFD.
    #[inline(never)]
    pub(super) fn read(&self, field: &str) -> Answer<String> {
        text(self, field)
    }
}

impl Number {
    /// 0 to 2³² − 1.
    #[inline(never)]
    pub(super) fn whole(&self, field: &str) -> Answer<u32> {
        let most = f64::from(u32::MAX);
        let whole = self.as_f64().filter(|n| (0.0..=most).contains(n) && *n == f64::from(*n as u32));
        whole.map(|n| n as u32).ok_or_else(|| not(field, "a whole number from 0 to 4294967295"))
    }

    /// Neither NaN nor infinite.
    #[cfg(feature = "whole")]
    pub(super) fn real(&self, field: &str) -> Answer<f64> {
        self.as_f64().filter(|n| n.is_finite()).ok_or_else(|| not(field, "a finite number"))
    }
}

impl Flag {
    #[inline(never)]
    pub(super) fn read(&self, field: &str) -> Answer<bool> {
        self.as_bool().ok_or_else(|| not(field, "true or false"))
    }
}

impl ParamValues {
    #[inline(never)]
    pub(super) fn read(&self, field: &str) -> Answer<Values> {
        let wrong = || not(field, "an object of numbers, texts, true and false");
        let keys = if Array::is_array(self) { None } else { Reflect::own_keys(self).ok() };
        let keys = keys.filter(|_| !self.is_function()).ok_or_else(wrong)?;
        let mut values = Values::new();
        for key in keys.iter() {
            let value = Reflect::get(self, &key).map_err(|_| wrong())?;
            let flag = || value.as_bool().map(Value::Flag);
            let read = value.as_f64().map(Value::Number).or_else(flag).or_else(|| value.as_string().map(Value::Text));
            values.insert(key.as_string().ok_or_else(wrong)?, read.ok_or_else(wrong)?);
        }
        Ok(values)
    }
}

impl Bytes {
    #[inline(never)]
    pub(super) fn read(&self, field: &str) -> Answer<Vec<u8>> {
        match self.dyn_ref::<Uint8Array>().filter(|_| ArrayBuffer::is_view(self)) {
            Some(view) => {
                let mut bytes = zeros(view.length(), field)?;
                view.copy_to(&mut bytes);
                Ok(bytes)
            }
            None => list(self, field, "a Uint8Array", &|n| n == f64::from(n as u8))
                .map(|list| list.iter().map(|&n| n as u8).collect()),
        }
    }
}

impl Heights {
    #[inline(never)]
    pub(super) fn read(&self, field: &str) -> Answer<Vec<f32>> {
        match self.dyn_ref::<Float32Array>().filter(|_| ArrayBuffer::is_view(self)) {
            Some(view) => {
                let mut heights = zeros(view.length(), field)?;
                view.copy_to(&mut heights);
                Ok(heights)
            }
            None => list(self, field, "a Float32Array", &|_| true).map(|list| list.iter().map(|&n| n as f32).collect()),
        }
    }
}

#[cfg(feature = "whole")]
impl Seconds {
    #[inline(never)]
    pub(super) fn read(&self, field: &str) -> Answer<Vec<f64>> {
        match self.dyn_ref::<js_sys::Float64Array>().filter(|_| ArrayBuffer::is_view(self)) {
            Some(view) => {
                let mut seconds = zeros(view.length(), field)?;
                view.copy_to(&mut seconds);
                Ok(seconds)
            }
            None => list(self, field, "a Float64Array", &|_| true),
        }
    }
}

/// A plain object, by its type's own rules. What is read is a copy without getters and circles: an exception that passes through the engine
/// would leave its stack as it was at that moment, and enough of them no stack at all.
pub(super) fn value<T: Tsify + DeserializeOwned>(given: &Ts<T>, field: &str) -> Answer<T> {
    let text = JSON::stringify(&given.js_value()).ok().and_then(|text| text.as_string());
    let copy = text.and_then(|text| JSON::parse(&text).ok()).ok_or_else(|| not(field, "plain data"))?;
    serde_wasm_bindgen::from_value(copy).map_err(|e| argument(field, &e.to_string()))
}

/// One of a few words. Nothing but a text is looked into: an object's getter could call back, or throw.
pub(super) fn word<T: DeserializeOwned>(given: &JsValue, field: &str) -> Answer<T> {
    let word: StringDeserializer<serde::de::value::Error> = text(given, field)?.into_deserializer();
    T::deserialize(word).map_err(|e| argument(field, &e.to_string()))
}

/// Throws for an argument that is not what it should be.
#[inline(never)]
pub(super) fn not(field: &str, expected: &str) -> JsValue {
    argument(field, &format!("{field} is not {expected}"))
}

/// Throws for an argument that cannot be used.
#[inline(never)]
pub(super) fn argument(field: &str, message: &str) -> JsValue {
    plain(&ErrorReport::new("bad-argument", field, message, "see the types of the package"))
}

#[inline(never)]
fn text(given: &JsValue, field: &str) -> Answer<String> {
    given.as_string().ok_or_else(|| not(field, "a text"))
}

/// Without memory it is the argument that is refused; the instance goes on.
fn zeros<T: Clone + Default>(length: u32, field: &str) -> Answer<Vec<T>> {
    let mut zeros = Vec::new();
    zeros.try_reserve_exact(length as usize).map_err(|_| argument(field, "there is no memory for so much"))?;
    zeros.resize(length as usize, T::default());
    Ok(zeros)
}

/// A plain list of numbers.
#[inline(never)]
fn list(given: &JsValue, field: &str, expected: &str, fits: &dyn Fn(f64) -> bool) -> Answer<Vec<f64>> {
    let wrong = || not(field, &format!("{expected} or a list of such numbers"));
    let length = given.dyn_ref::<Array>().ok_or_else(wrong)?.length();
    let number = |i| Reflect::get_u32(given, i).ok()?.as_f64().filter(|&n| fits(n));
    (0..length).map(|i| number(i).ok_or_else(wrong)).collect()
}
