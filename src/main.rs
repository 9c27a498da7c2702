//! The command line of Formicarium. Everything it does is in the library; here are arguments, files and print-outs.

#[cfg(not(target_arch = "wasm32"))]
mod cli;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    cli::run()
}

/// The browser uses the library; there is no command line in it.
#[cfg(target_arch = "wasm32")]
fn main() {}
