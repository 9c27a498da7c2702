//! The command line's program. What it does is in the library: `cli/`.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    formicarium::cli::run(std::env::args_os()).into()
}

/// The browser uses the library; there is no command line in it.
#[cfg(target_arch = "wasm32")]
fn main() {}
