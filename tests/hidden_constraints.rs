//! What assumptions about a motion say only after they were differentiated several times: beside closed forms, and beside linear
//! algebra on random linear systems.

use crate::identity::test;
use rederive::check::identity::Identity;

#[test]
fn a_circular_orbit_determines_its_angular_momentum() {
    // Landau & Lifshitz, Mechanics, § 15: the canonical equations in polar coordinates.
    let orbit = "m > 0; R > 0; k > 0; r' = p/m; p' = M^2/(m*r^3) - k/r^2; f' = M/(m*r^2); M' = 0; r = R; R' = 0";
    let moving = "r p f M R";
    for claim in ["p = 0", "M^2 = m*k*R", "p^2/(2*m) + M^2/(2*m*r^2) - k/r = -k/(2*R)"] {
        assert!(matches!(test(claim, orbit, moving), Identity::Proved(_)), "{claim}");
    }
    for claim in ["M^2 = 2*m*k*R", "M = 0", "f' = 1"] {
        assert!(!matches!(test(claim, orbit, moving), Identity::Proved(_)), "{claim}");
    }
    // A constraint on a pendulum in the plane determines its tension only after two derivatives.
    let pendulum = "l > 0; x' = u; y' = v; u' = s*x; v' = s*y - g; x^2 + y^2 = l^2; l' = 0; g' = 0";
    let tension = "s*l^2 = g*y - u^2 - v^2";
    assert!(matches!(test(tension, pendulum, "x y u v s l g"), Identity::Proved(_)));
    assert!(!matches!(test("s*l^2 = g*y - u^2 + v^2", pendulum, "x y u v s l g"), Identity::Proved(_)));
}

/// Small whole numbers, the same each time.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self, of: &[i64]) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        of[(self.0 >> 33) as usize % of.len()]
    }
}

const PRIME: i128 = 2_305_843_009_213_693_951;

/// The rank modulo a large prime: for such small numbers, that over the rationals.
fn rank(rows: &[Vec<i64>]) -> usize {
    let mut rows: Vec<Vec<i128>> =
        rows.iter().map(|r| r.iter().map(|&x| i128::from(x).rem_euclid(PRIME)).collect()).collect();
    let mut rank = 0;
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..rows.len()).find(|&i| rows[i][column] != 0) else { continue };
        rows.swap(rank, pivot);
        let top = rows[rank].clone();
        for row in &mut rows[rank + 1..] {
            // Without division: both rows are multiplied.
            let (a, b) = (top[column], row[column]);
            for (x, t) in row.iter_mut().zip(&top) {
                *x = (*x * a - t * b).rem_euclid(PRIME);
            }
        }
        rank += 1;
    }
    rank
}

fn linear(row: &[i64]) -> String {
    let terms: Vec<String> = row.iter().zip(["x", "y", "z", "w"]).map(|(c, v)| format!("({c})*{v}")).collect();
    terms.join(" + ")
}

#[test]
fn linear_systems_agree_with_linear_algebra() {
    let mut numbers = Numbers(5);
    let (mut followed, mut others) = (0, 0);
    for _ in 0..40 {
        let n = 2 + numbers.next(&[0, 1, 1, 2]) as usize;
        let matrix: Vec<Vec<i64>> =
            (0..n).map(|_| (0..n).map(|_| numbers.next(&[0, 0, 1, -1, 2, -1, 3])).collect()).collect();
        let times = |row: &[i64]| -> Vec<i64> { (0..n).map(|j| (0..n).map(|i| row[i] * matrix[i][j]).sum()).collect() };
        let given: Vec<i64> = (0..n).map(|_| numbers.next(&[0, 1, -1, 2])).collect();
        // c·x = a, cA·x = 0, cA²·x = 0 …: the last column is that of −a.
        let mut rows: Vec<Vec<i64>> = Vec::new();
        let mut row = given.clone();
        for order in 0..n + 2 {
            rows.push(row.iter().copied().chain([-i64::from(order == 0)]).collect());
            row = times(&row);
        }
        let closed = rank(&rows);
        // With the row of a alone, the assumption cannot hold.
        let level = |a: i64| -> Vec<i64> { vec![0; n].into_iter().chain([a]).collect() };
        let mut claims: Vec<Vec<i64>> = vec![(0..=n).map(|_| numbers.next(&[0, 1, -1])).collect(), level(1)];
        for _ in 0..3 {
            let by: Vec<i64> = rows[..n].iter().map(|_| numbers.next(&[0, 1, -1, 2])).collect();
            claims.push((0..=n).map(|j| (0..n).map(|i| by[i] * rows[i][j]).sum()).collect());
        }
        let system: Vec<String> =
            matrix.iter().zip(["x", "y", "z", "w"]).map(|(row, v)| format!("{v}' = {}", linear(row))).collect();
        let premises = format!("{}; {} = a", system.join("; "), linear(&given));
        for claim in claims {
            let text = format!("{} = ({})*a", linear(&claim[..n]), -claim[n]);
            let follows = rank(&[rows.as_slice(), &[claim]].concat()) == closed;
            let found = test(&text, &premises, "x y z w");
            match follows {
                true => {
                    followed += 1;
                    assert!(!matches!(found, Identity::Refuted(_)), "{text} given {premises}");
                    assert!(matches!(found, Identity::Proved(_)), "{text} given {premises}: {found:?}");
                }
                false => {
                    others += 1;
                    assert!(!matches!(found, Identity::Proved(_)), "{text} given {premises}");
                }
            }
        }
    }
    assert!(followed > 100 && others > 10, "{followed} {others}");
}
