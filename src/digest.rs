//! The result digest: 64 bits over best path, its length and the iteration history. Equal digests mean equal runs, on any machine.

/// FNV-1a over little-endian bytes; lengths are hashed as `u32`, never as `usize`, so that 32- and 64-bit machines agree.
///
/// ```
/// use formicarium::digest::Digest;
///
/// let mut digest = Digest::default();
/// digest.u32(7);
/// digest.f64(2.5);
/// assert_eq!(digest.hex().len(), 16);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// Adds bytes.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for &b in bytes {
            self.0 = (self.0 ^ u64::from(b)).wrapping_mul(0x100_0000_01b3);
        }
    }

    /// Adds a whole number.
    pub fn u32(&mut self, v: u32) {
        self.bytes(&v.to_le_bytes());
    }

    /// Adds a real number by its bits; all NaNs count as one.
    pub fn f64(&mut self, v: f64) {
        let bits = if v.is_nan() { 0x7ff8_0000_0000_0000 } else { v.to_bits() };
        self.bytes(&bits.to_le_bytes());
    }

    /// The digest as 16 hexadecimal digits.
    pub fn hex(self) -> String {
        format!("{:016x}", self.0)
    }
}
