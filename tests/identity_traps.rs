//! What must never be proved, and what orthogonal matrices and sums of squares add.

use crate::comment::{determinant, orthogonal};
use crate::infix::Reader;
use rederive::check::identity::order::{Fate, Question, Requirement, decide};
use rederive::check::identity::{Condition, Identity, Options, Reason, identity_test};

fn test(claim: &str, premises: &str) -> Identity {
    let mut r = Reader::default();
    let equations = r.equations(claim);
    let given = r.premises(premises, "");
    identity_test(&mut r.graph, &equations, &given, &Options::default())
}

#[track_caller]
fn refuted(claim: &str, premises: &str) {
    let found = test(claim, premises);
    assert!(matches!(found, Identity::Refuted(_)), "`{claim}` given `{premises}`: {found:#?}");
}

#[track_caller]
fn not_proved(claim: &str, premises: &str) {
    let found = test(claim, premises);
    assert!(!matches!(found, Identity::Proved(_)), "`{claim}` given `{premises}`: {found:#?}");
}

/// Proved, and nothing was divided by on the way.
#[track_caller]
fn proved_everywhere(claim: &str, premises: &str) {
    match test(claim, premises) {
        Identity::Proved(p) => {
            assert!(!p.conditions.iter().any(|c| matches!(c, Condition::Pivot(_))), "{:?}", p.conditions);
            assert!(p.example.is_some() && p.log2_error <= -100.0);
        }
        other => panic!("`{claim}` given `{premises}`: {other:#?}"),
    }
}

#[test]
fn true_for_some_values_only() {
    refuted("sqrt(x^2) = x", "");
    refuted("sqrt(x^4) = x*abs(x)", "");
    refuted("sqrt(x^2*y) = x*sqrt(y)", "y > 0");
    refuted("exp(ln(x^2)/2) = x", "");
    refuted("abs(x + y) = abs(x) + abs(y)", "");
    // Modulo 2π only.
    refuted("arctan(tan(x)) = x", "");
    refuted("atan2(sin(2*x), cos(2*x)) = 2*x", "");
    refuted("arccos(cos(x)) = x", "");
    // The denominator vanishes where the premises hold.
    not_proved("1/(a - b) = 1/(a - b)", "a = b");
    not_proved("(a^2 - b^2)/(a - b) = a + b", "a = b");
    not_proved("(x - x)/(sin(y)^2 + cos(y)^2 - 1) = 0", "");
}

#[test]
fn what_holds_where_something_is_not_zero() {
    refuted("x = b", "a*x = a*b");
    refuted("x = 1", "(a - b)*x = a - b");
    refuted("x = y", "a*x + c*x = a*y + c*y");
    // For a ≠ 0 the premises contradict each other; they hold with a = 0.
    refuted("a = 1", "a*x = a*c; (x - c)*y = 1");
    not_proved("y = 5", "a*x = a*c; (x - c)*y = 1");
    assert_eq!(test("y = 5", "x = c; (x - c)*y = 1"), Identity::Undecided(Reason::Contradiction));
}

#[test]
fn orthogonal_matrices_have_either_orientation() {
    let given = orthogonal("R");
    let proper = format!("{given}; {}", determinant("R"));
    let rows = "R11*R21 + R12*R22 + R13*R23 = 0; R11^2 + R12^2 + R13^2 = 1; R31^2 + R32^2 + R33^2 = 1";
    proved_everywhere(rows, &given);
    let cofactor = "R33 = R11*R22 - R12*R21";
    refuted(cofactor, &given);
    proved_everywhere(cofactor, &proper);
    refuted(&determinant("R"), &given);
    proved_everywhere("(R11*R22 - R12*R21)^2 = R33^2", &given);
    refuted("R11 + R22 + R33 = 1", &proper);
    // Two dimensions.
    let plane = "a^2 + c^2 = 1; b^2 + d^2 = 1; a*b + c*d = 0";
    proved_everywhere("a^2 = d^2; a^2 + b^2 = 1", plane);
    refuted("a = d", plane);
    proved_everywhere("a = d; b = -c", &format!("{plane}; a*d - b*c = 1"));
    refuted("a = d", &format!("{plane}; a*d - b*c = -1"));
}

#[test]
fn what_is_nearly_an_orthogonal_matrix_is_none() {
    let all = orthogonal("R");
    let rows = "R11*R21 + R12*R22 + R13*R23 = 0";
    let without = |part: &str| {
        let kept: Vec<&str> = all.split("; ").filter(|p| !p.contains(part)).collect();
        assert_eq!(kept.len(), 5, "{part}");
        kept.join("; ")
    };
    not_proved(rows, &without("R11*R12"));
    not_proved(rows, &without("R13*R13"));
    not_proved(rows, &all.replace("R21*R22", "R22*R23"));
    not_proved("R11^2 + R12^2 + R13^2 = 1", &all.replace("R33*R33 = 1", "R33*R33 = 2"));
}

#[test]
fn sums_of_squares() {
    proved_everywhere("x = 0; y = 0", "x^2 + y^2 = 0");
    proved_everywhere("x = y; z = 0", "3*(x - y)^2 + 2*z^2 = 0");
    proved_everywhere("sin(u) = 0", "sin(u)^2 + x^2*y^2 = 0");
    refuted("x = 1", "x^2 + y^2 = 0");
    refuted("x = 0", "x^2 - y^2 = 0");
    refuted("x = 0", "x^2*y^2 + z^2 = 0");
    refuted("x = 0", "x^3 + y^2 = 0");
    assert_eq!(test("x = 5", "x^2 + y^2 + 1 = 0"), Identity::Undecided(Reason::Contradiction));
}

#[test]
fn signs_of_multiples() {
    proved_everywhere("abs(a*x^2 + b*x^2) = x^2*abs(a + b)", "");
    proved_everywhere("abs(a/x + b/x)*abs(x) = abs(b + a)", "");
    refuted("abs(a*x + b*x) = x*abs(a + b)", "");
}

#[test]
fn arguments_have_a_common_measure() {
    proved_everywhere("exp(1467*x)*exp(-1467*x) = 1", "");
    proved_everywhere("cos(1467*x)^2 + sin(1467*x)^2 = 1", "");
    proved_everywhere("cos(2934*x/7) = 2*cos(1467*x/7)^2 - 1", "");
    proved_everywhere("cos(4401*x) = 4*cos(1467*x)^3 - 3*cos(1467*x)", "");
    refuted("cos(4401*x) = 4*cos(1467*x)^3 + 3*cos(1467*x)", "");
    proved_everywhere("sin(3*x/2 + 9*y/4) = sin(3*x/2)*cos(9*y/4) + cos(3*x/2)*sin(9*y/4)", "");
    refuted("sin(3*x/2 + 9*y/4) = sin(3*x/2)*cos(9*y/4) - cos(3*x/2)*sin(9*y/4)", "");
    proved_everywhere("exp(5*x/3)*exp(5*x/6) = exp(5*x/2)", "");
    refuted("exp(5*x/3)*exp(5*x/6) = exp(5*x/4)", "");
    proved_everywhere("sin(10*x/3) = 2*sin(5*x/3)*cos(-5*x/3)", "");
    refuted("sin(10*x/3) = 2*sin(-5*x/3)*cos(5*x/3)", "");
    not_proved("exp(1467*x)*exp(-1468*x) = 1", "");
    not_proved("cos(2934*x/7) = 2*cos(1466*x/7)^2 - 1", "");
}

/// The fates of a claim about positive parameters, as text.
fn orders(names: &str, assumed: &[(Requirement, &str)], claimed: &[(Requirement, &str)]) -> (String, bool) {
    let mut r = Reader::default();
    let parameters = names.split(' ').map(|n| r.leaf(n)).collect();
    let mut read = |list: &[(Requirement, &str)]| list.iter().map(|&(k, text)| (k, r.read(text))).collect();
    let (assumed, claimed) = (read(assumed), read(claimed));
    let found = decide(&mut r.graph, &Question { parameters, assumed, claimed, asserted: true });
    let names: Vec<String> = names.split(' ').map(str::to_owned).collect();
    (found.words(&names), found.is_proved())
}

#[test]
fn orders_of_size() {
    use Requirement::{NotNegative, NotZero, Positive, Zero};
    let ratio = "b*(c - a)/(c*(b - a))";
    let rest = "1 - b*(c - a)/(c*(b - a))";
    let (words, proved) = orders("a b c", &[], &[(NotNegative, ratio), (NotNegative, rest)]);
    assert!(
        words.starts_with("exactly when a and b differ, and c lies between them or is equal to one of them"),
        "{words}"
    );
    assert!(!proved);
    let between = [(NotNegative, "(c - a)*(b - c)"), (NotZero, "a - b")];
    assert!(orders("a b c", &between, &[(NotNegative, ratio), (NotNegative, rest)]).1);
    assert!(!orders("a b c", &between, &[(Positive, ratio)]).1, "c may equal a");
    assert_eq!(orders("a b", &[], &[(Positive, "a - b")]).0, "exactly when b < a");
    assert_eq!(orders("a b", &[], &[(Positive, "a + b")]), ("always".to_owned(), true));
    let open = orders("a b", &[], &[(Zero, "sqrt((a - b)^2) - abs(b - a)")]).0;
    assert!(open.contains("not settled"), "{open}");
    // More than the order decides: nothing is claimed.
    let (words, proved) = orders("a b", &[], &[(Positive, "3*a - 2*b")]);
    assert!(!proved && words.contains("not for all values, or not settled, when a < b"), "{words}");
    // Nothing that no order admits is proved.
    assert!(!orders("a b", &[(Positive, "a - a - b")], &[(Positive, "a")]).1);
    let mut r = Reader::default();
    let (parameters, e) = (vec![r.leaf("a"), r.leaf("b")], r.read("a^2 - 3*a*b + b^2"));
    let claimed = vec![(Positive, e)];
    let found = decide(&mut r.graph, &Question { parameters, assumed: Vec::new(), claimed, asserted: true });
    assert!(found.list.iter().any(|(_, fate)| matches!(fate, Fate::FailsAt(_))), "{found:?}");
    assert!(!found.list.iter().any(|(order, fate)| order.len() == 2 && *fate == Fate::Holds), "{found:?}");
}
