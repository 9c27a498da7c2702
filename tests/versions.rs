//! One version everywhere: the crate, the npm library, the page.
#![cfg(not(target_arch = "wasm32"))]

#[test]
fn npm_manifests_carry_the_crates_version() {
    for file in ["pkg.json", "www/package.json"] {
        let path = format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).expect(file);
        let manifest: serde_json::Value = serde_json::from_str(&text).expect(file);
        assert_eq!(manifest["version"], env!("CARGO_PKG_VERSION"), "{file}");
    }
}
