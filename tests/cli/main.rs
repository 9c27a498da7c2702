//! The real binary: every subcommand, its output, its errors and its exit codes.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../formats/figure_picture.rs"]
mod figure_picture;
#[path = "../formats/schema.rs"]
mod schema;

mod ablation;
mod again;
mod check;
mod compare;
mod devices;
mod drive;
mod driving;
mod figure;
mod files;
mod folder;
mod full_disk;
mod interrupted;
mod journal;
mod kept_files;
mod order;
mod page;
mod path_out;
mod plan;
mod quantities;
mod results;
mod shards;
mod terrain;
mod weighted;
