//! A small deterministic generator: the same seed gives the same draws on every machine.

/// SplitMix64 ([Steele, Lea & Flood 2014]): 64 bits a call, period 2⁶⁴, every seed is good.
///
/// [Steele, Lea & Flood 2014]: https://doi.org/10.1145/2714064.2660195
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Draws {
    state: u64,
}

impl Draws {
    /// Starts from a seed.
    pub fn new(seed: u64) -> Draws {
        Draws { state: seed }
    }

    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A uniform number in 0 … n − 1 (rejection, so without bias); 0 for n ≤ 1.
    pub fn below(&mut self, n: u64) -> u64 {
        if n <= 1 {
            return 0;
        }
        let zone = u64::MAX - u64::MAX % n;
        loop {
            let x = self.bits();
            if x < zone {
                return x % n;
            }
        }
    }
}
