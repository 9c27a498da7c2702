//! Makes a faulty file smaller: leaves out halves, quarters, … as long as the same thing is wrong.

use crate::corpus::File;
use crate::readers::Reader;
use crate::watch::Fault;

/// A slow input is tried less often.
const TRIES: usize = 600;

pub fn shrink(reader: &Reader, file: &File, fault: &Fault) -> File {
    let mut small = file.clone();
    let mut tries = if fault.kind == "time" { TRIES / 20 } else { TRIES };
    let mut size = small.bytes.len().div_ceil(2);
    while size > 0 {
        let mut at = 0;
        while at < small.bytes.len() && tries > 0 {
            tries -= 1;
            let mut bytes = small.bytes.clone();
            bytes.drain(at..(at + size).min(bytes.len()));
            let less = File { bytes, name: small.name.clone() };
            match reader.check(&less) {
                Err(other) if other.is_like(fault) => small = less,
                _ => at += size,
            }
        }
        size /= 2;
    }
    small
}
