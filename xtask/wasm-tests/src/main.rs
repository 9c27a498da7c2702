//! Cargo's runner for WebAssembly tests (`.cargo/config.toml`): wasm-bindgen's own, in the version that the engine is bound by.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(std::env::args_os())
}
