//! `cargo xtask serve`: the page on this machine, built once or rebuilt while one edits.

use std::fs;
use std::io::ErrorKind;
use std::net::{SocketAddr, TcpListener, TcpStream, ToSocketAddrs};
use std::path::Path;
use std::process::Child;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, SystemTime};

use anyhow::{Context, Result, bail};
use clap::Args;

use crate::page;
use crate::tools::{root, vite};
use crate::wasm::{self, Mode};

#[derive(Args)]
pub struct Options {
    /// Reload the page while its sources change, rebuild the engine while src/ changes
    #[arg(long)]
    dev: bool,
    /// The port, or the first free one after it
    #[arg(long, default_value_t = 8080)]
    port: u16,
    /// Where to listen; 0.0.0.0 lets other machines in
    #[arg(long, default_value = "localhost")]
    host: String,
}

pub fn serve(options: &Options) -> Result<()> {
    if options.dev {
        wasm::build(Mode::Dev)?;
    } else {
        page::build(None)?;
    }
    let port = free_port(&options.host, options.port)?;
    let mut server = start(options, port)?;
    println!("Formicarium runs at http://{}:{port}/ (Ctrl-C ends it)", shown(&options.host));
    if options.dev {
        thread::spawn(rebuild_on_change);
    }
    server.wait()
}

/// Vite's own server, ready to answer.
fn start(options: &Options, port: u16) -> Result<Server> {
    let mut vite = vite();
    vite.args(if options.dev { ["dev"] } else { ["preview"] });
    vite.args(["--strictPort", "--logLevel", "warn", "--host", &options.host]);
    let server = Server::new(vite.args(["--port", &port.to_string()]).spawn()?)?;
    server.wait_for(&options.host, port)?;
    Ok(server)
}

fn free_port(host: &str, first: u16) -> Result<u16> {
    (first..first.saturating_add(100))
        .find(|port| is_free(host, *port))
        .with_context(|| format!("no free port on {host} from {first} on: choose one with --port"))
}

/// Taken on one of the host's addresses is taken; what else may be wrong, Vite says better.
fn is_free(host: &str, port: u16) -> bool {
    let taken = |address| TcpListener::bind::<SocketAddr>(address).is_err_and(|error| error.kind() == ErrorKind::AddrInUse);
    !(host, port).to_socket_addrs().into_iter().flatten().any(taken)
}

/// An address one can open: "any interface" is not.
fn shown(host: &str) -> &str {
    match host {
        "0.0.0.0" | "::" => "localhost",
        host => host,
    }
}

/// A program that ends with us, whether we return, fail or are told to stop.
struct Server(Arc<Mutex<Child>>);

impl Server {
    fn new(child: Child) -> Result<Self> {
        let child = Arc::new(Mutex::new(child));
        let ours = Arc::clone(&child);
        ctrlc::set_handler(move || {
            let _ = ours.lock().map(|mut child| child.kill());
            std::process::exit(0);
        })?;
        Ok(Self(child))
    }

    fn has_ended(&self) -> Result<bool> {
        Ok(self.0.lock().expect("no holder panics").try_wait()?.is_some())
    }

    fn wait_for(&self, host: &str, port: u16) -> Result<()> {
        let address = (shown(host), port);
        for _ in 0..300 {
            if self.has_ended()? {
                break;
            }
            if address.to_socket_addrs()?.any(|address| TcpStream::connect(address).is_ok()) {
                return Ok(());
            }
            thread::sleep(Duration::from_millis(100));
        }
        bail!("Vite does not answer on {host}:{port}")
    }

    fn wait(&mut self) -> Result<()> {
        while !self.has_ended()? {
            thread::sleep(Duration::from_millis(200));
        }
        bail!("the server has ended")
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.0.lock().map(|mut child| child.kill());
    }
}

/// Vite watches pkg/ and reloads the page; a failed compilation leaves the old engine.
fn rebuild_on_change() {
    let mut built = newest_change();
    loop {
        thread::sleep(Duration::from_millis(500));
        let changed = newest_change();
        if changed != built {
            built = changed;
            if let Err(error) = wasm::build(Mode::Dev) {
                eprintln!("error: {error:#}");
            }
        }
    }
}

/// How many sources the engine has, and when one of them last changed.
fn newest_change() -> (usize, Option<SystemTime>) {
    let mut times = Vec::new();
    modification_times(&root().join("src"), &mut times);
    modification_times(&root().join("Cargo.toml"), &mut times);
    (times.len(), times.into_iter().max())
}

fn modification_times(path: &Path, times: &mut Vec<SystemTime>) {
    for entry in fs::read_dir(path).into_iter().flatten().flatten() {
        modification_times(&entry.path(), times);
    }
    times.extend(fs::metadata(path).and_then(|file| file.modified()));
}
