//! The engine as WebAssembly, in node and in Chromium: frozen results and the browser boundary.
#![cfg(target_arch = "wasm32")]

#[path = "golden_cases/mod.rs"]
mod golden;

use formicarium::digest::Digest;
use formicarium::map::{Generator, generate};
use formicarium::wasm;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn results_are_the_frozen_ones() {
    golden::check_all();
}

#[wasm_bindgen_test]
fn the_catalog_crosses_as_plain_objects() {
    let catalog = wasm::catalog().js_value();
    let planners = js_sys::Reflect::get(&catalog, &"planners".into()).expect("an object");
    assert!(js_sys::Array::is_array(&planners));
    assert_eq!(js_sys::Array::from(&planners).length() as usize, formicarium::catalog::CATALOG.len());
}

#[wasm_bindgen_test]
fn errors_are_objects_with_kind_field_message_and_hint() {
    for bytes in [&b""[..], b"\xff\xfe\x00", b"type octile\nheight 9\nwidth 99999999\nmap\n"] {
        let (bytes, name) = (js_sys::Uint8Array::from(bytes), JsValue::from("x.map"));
        let error = wasm::import_map(bytes.unchecked_ref(), name.unchecked_ref(), None, None).expect_err("no map");
        for key in ["kind", "field", "message", "hint"] {
            let value = js_sys::Reflect::get(&error, &key.into()).expect("an object");
            assert!(value.as_string().is_some_and(|s| !s.is_empty()), "{key}");
        }
    }
}

/// The digests that `map::generate`'s own test freezes natively.
#[wasm_bindgen_test]
fn made_maps_have_the_same_bits() {
    let golden = [
        (Generator::Blocks, "5bf0800ed0d18a4e"),
        (Generator::Bars, "d16b3a0d94798f7f"),
        (Generator::Fractal, "e66abdfd28e817a1"),
        (Generator::Hills, "479969d69fde95d5"),
    ];
    for (kind, golden) in golden {
        let made = generate(kind, 64, 48, 1, 0.3).expect("a valid size");
        let mut digest = Digest::default();
        digest.bytes(&made.grid.to_bytes());
        assert_eq!(made.grid.heights().is_some(), kind.is_terrain());
        made.grid.heights().iter().flat_map(|h| h.iter()).for_each(|h| digest.bytes(&h.to_le_bytes()));
        assert_eq!(digest.hex(), golden, "{kind:?}");
    }
}

#[wasm_bindgen_test]
fn seeds_are_proposed_by_the_system() {
    let seeds: Vec<u32> = (0..4).map(|_| wasm::propose_seed().expect("a source of randomness")).collect();
    assert!(seeds.iter().any(|s| *s != seeds[0]));
}
