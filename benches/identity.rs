//! Every identity of the Comment: by random evaluation, and by certificates.

#[path = "../tests/comment/mod.rs"]
mod comment;
#[path = "../tests/infix/mod.rs"]
mod infix;

use infix::Reader;
use rederive::check::identity::{Options, Premises, identity_test};
use rederive::expr::Expr;

fn main() {
    divan::main();
}

type Ready = (Reader, Vec<(Expr, Expr)>, Premises);

fn ready(ids: impl Fn(&str) -> bool) -> Vec<Ready> {
    let steps = comment::steps().into_iter().filter(|s| ids(s.id));
    steps
        .map(|s| {
            let mut r = Reader::default();
            let equations = r.equations(&s.claim);
            let given = r.premises(&s.premises, &s.moving);
            (r, equations, given)
        })
        .collect()
}

fn all(mut problems: Vec<Ready>) -> usize {
    let one = |(r, equations, given): &mut Ready| {
        identity_test(&mut r.graph, equations, given, &Options::default()).word() == "proved"
    };
    problems.iter_mut().map(one).filter(|&p| p).count()
}

#[divan::bench]
fn whole_comment(bencher: divan::Bencher<'_, '_>) {
    bencher.with_inputs(|| ready(|_| true)).bench_values(all);
}

/// t9, t10, t11 squared, ψ₀, t15: the set that is compared with other programs.
#[divan::bench]
fn seven(bencher: divan::Bencher<'_, '_>) {
    let ids = ["t10", "t11 squared", "psi0 solves t9c", "t15 solves t9"];
    bencher.with_inputs(|| ready(|id| ids.contains(&id))).bench_values(all);
}

#[divan::bench(args = ["t10", "psi0", "t9 from t7.1", "t3", "omega of m", "Euler from m conserved", "t15 solves t9", "S obeys the E-m relation", "S = R(0)^T R solves t3 with m_S"])]
fn single(bencher: divan::Bencher<'_, '_>, id: &str) {
    bencher.with_inputs(|| ready(|other| other == id)).bench_values(all);
}
