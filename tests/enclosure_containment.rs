//! What is known in closed form lies in its enclosure: 1,000 random starts and times per case, without exception.
//!
//! That the comparison can fail is shown beside the code, where a test can break rounding, remainder and directions
//! (`src/flow/enclosure/tests.rs`).

use crate::enclosure_support::CASES;

#[test]
fn closed_forms_are_inside() {
    for (k, case) in CASES.iter().enumerate() {
        let (compared, outside) = case.compare(1000, 40 + k as u64);
        assert!(compared >= 1000, "{}: {compared}", case.name);
        assert_eq!(outside, 0, "{}: of {compared}", case.name);
    }
}
