//! Facts that are known at some times, or places, or of some values, and what they do not say of others: leaps that are reached through
//! another argument, zeros that are factors, signs at chosen places, integrals at single times, rates at the start.

use rederive::check::{Account, Outcome};

use crate::premises::{of_file, standing};
use crate::prove_traps::all;

#[test]
fn a_function_leaps_where_its_other_argument_passes_zero() {
    all(&[
        ("unproved", r"\operatorname{atan2}(0,x)=\operatorname{atan2}(0,x(0))", "x: state", ""),
        ("unproved", r"\operatorname{atan2}(a,x)=\operatorname{atan2}(a,x(0))", "x: state; a", r"a\dot x=0"),
        ("unproved", r"\operatorname{atan2}(\sqrt a,x)=\operatorname{atan2}(\sqrt a,x(0))", "x: state; a", ""),
        ("unproved", r"\operatorname{atan2}(1-1,x)=\operatorname{atan2}(1-1,x(0))", "x: state", ""),
        ("unproved", r"\operatorname{atan2}(y(0),x)=\operatorname{atan2}(y(0),x(0))", "x, y: state", "y(0)=0"),
        ("unproved", r"\operatorname{atan2}(a,x)=\operatorname{atan2}(a,x(0))", "x: state; a", "a=0"),
    ]);
    all(&[
        ("refuted", r"\operatorname{atan2}(0,x)=0", "x: state", r"x(0)=1; \dot x=-1"),
        ("refuted", r"\operatorname{atan2}(0,x)=0", "x: state", "x(0)=1"),
        ("unproved", r"\cos(\operatorname{atan2}(0,x))=1", "x: state", "x(0)=1"),
        (
            "unproved",
            r"\operatorname{atan2}(a,x)=z",
            "x, z: state; a",
            r"(a^2+x^2)\dot z=-a\dot x; \operatorname{atan2}(a,x(0))=z(0)",
        ),
        // Where the first argument is not 0, nothing leaps.
        (
            "proved",
            r"\operatorname{atan2}(1,x)=z",
            "x, z: state",
            r"(1+x^2)\dot z=-\dot x; \operatorname{atan2}(1,x(0))=z(0)",
        ),
    ]);
}

#[test]
fn a_zero_is_a_factor() {
    for given in [
        r"0x\dot x=0",
        r"(1-1)x\dot x=0",
        r"\left(\frac12-0.5\right)x\dot x=0",
        r"(\sqrt2-\sqrt2)x\dot x=0",
        r"\frac0{x^2}=0",
        r"\frac0{e^x}=0",
        r"\frac0a x^2=0",
        r"\frac{\sin0}{a}x^2=0",
    ] {
        all(&[("unproved", "x=x(0)", "x: state; a", given), ("unproved", "x(1)=x(0)", "x: state; a", given)]);
    }
    all(&[
        ("unproved", "xy=x(0)y(0)", "x, y: state", r"(1-1)x\dot y=0; (1-1)y\dot x=0"),
        ("proved", "x=x(0)", "x: state", r"2x\dot x=0"),
    ]);
}

#[test]
fn a_sign_at_chosen_places_is_not_one_at_others() {
    let field = "x: coordinate; f(x): field";
    all(&[
        ("unproved", "|f(0)|=f(0)", field, "x=1; f>0"),
        ("unproved", "|f(0)|=f(0)", field, "x>1; f>0"),
        ("unproved", "|f(0)|=f(0)", field, r"x=1; f\ge0"),
        ("unproved", "|f(1)|=f(1)", field, "x>0; xf>0"),
        ("unproved", r"\frac{f(0)}{|f(0)|}=1", field, "x=1; f>0"),
        // What is typed is given at all places, where none is chosen.
        ("proved", "|f(0)|=f(0)", field, "f>0"),
    ]);
}

#[test]
fn two_sizes_of_one_number_are_solved_case_by_case() {
    let root = r"\sqrt{x^2+4}=x\sqrt{1+\frac{4}{x^2}}";
    all(&[
        ("refuted", root, "x", "|x|=-x; |x-2|=2-x"),
        ("refuted", root, "x", "|x|=-x; |x-3|=3-x"),
        ("unrefuted", root, "x", "|x|=x; |x-2|=2-x"),
        ("refuted", r"\sin(\operatorname{atan2}(2,x))=\sin(\arctan\frac2x)", "x", "|x|=-x; |x-2|=2-x"),
        ("proved", r"\sqrt{(x-2)^2}=2-x", "x", "|x-2|=2-x"),
        ("refuted", "x=2", "x", "|x-2|=2-x"),
    ]);
}

const HEAD: &str = "
'x' = { role = 'state' }
'y' = { role = 'state' }
'w' = { role = 'observable', formula = '6-x' }
'v' = { role = 'observable', formula = '\\sqrt x' }
'a' = { role = 'parameter' }
";

fn file(rest: &str) -> Account {
    of_file(&format!("{HEAD}{rest}"))
}

#[test]
fn a_leap_is_excluded_by_what_holds_at_all_times_only() {
    for chosen in ["t>1", "y>1", r"y\ge0", r"\sqrt y\ge0", r"t(1-t)\le0"] {
        for formula in [r"\lfloor x\rfloor=\lfloor x(0)\rfloor", r"\lceil x\rceil=\lceil x(0)\rceil"] {
            let claim = format!(
                "[[claim]]\nid = 'c'\nsays = 'test'\nassuming = ['{chosen}', '\\dot x=0']\nalways = ['{formula}']\n"
            );
            assert_ne!(standing(&file(&claim), "c"), "proved", "{chosen}: {formula}");
        }
    }
}

#[test]
fn an_integral_at_single_times_says_nothing_of_its_rate() {
    for (chosen, proved) in
        [(r"y\ge1", false), (r"\sqrt{-y^2}>-1", false), (r"\lfloor y\rfloor>0", false), ("y>1", true)]
    {
        let claims = format!(
            "[[claim]]\nid = 'f'\nsays = 'test'\nassuming = ['{chosen}']\nfirst-integral = ['x']\n\
             [[claim]]\nid = 'c'\nsays = 'test'\nassuming = ['{chosen}']\nfollows-from = ['f']\nalways = ['\\dot x=0']\n"
        );
        assert_eq!(standing(&file(&claims), "c").starts_with("proved"), proved, "{chosen}");
    }
}

/// What a claim came to on its motion.
fn on_motion(account: &Account, id: &str) -> Outcome {
    let claim = account.claims.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("no claim {id}"));
    claim.results.first().map_or(Outcome::Undecided, |p| p.verdict.outcome())
}

#[test]
fn the_rate_of_an_observable_at_the_start_is_that_of_its_formula() {
    let account = file(
        r"
[[trajectory]]
id = 'm'
formula = { 'x' = 't', 'y' = '1' }
span = [0, 2]
[[claim]]
id = 'equal'
says = 'test'
eventually = ['\dot w=\lfloor x\rfloor']
[[claim]]
id = 'product'
says = 'test'
never = ['\dot w\lfloor x+\frac72\rfloor=0']
[[claim]]
id = 'rate'
says = 'test'
never = ['\dot w+\lfloor x\rfloor=-1']
",
    );
    assert!(!matches!(on_motion(&account, "equal"), Outcome::Holds(_)));
    assert!(!matches!(on_motion(&account, "product"), Outcome::Fails(_)));
    // −1 + 0 = −1 at the start.
    assert!(matches!(on_motion(&account, "rate"), Outcome::Fails(_)));
}

#[test]
fn what_needs_a_value_fails_where_it_has_none_for_certain() {
    let account = file(
        r"
[system.s]
states = ['x', 'y']
equations = ['\dot x=1', '\dot y=x']
[[trajectory]]
id = 'm'
system = 's'
initial = { 'x' = -2, 'y' = 1 }
span = [-2, 2]
initial-time = -2
[[claim]]
id = 'later'
says = 'test'
assuming = ['t>0']
defined = ['\frac1x']
[[claim]]
id = 'odd'
says = 'test'
assuming = ['t>0']
defined = ['\frac1{x^3}']
[[claim]]
id = 'leap'
says = 'test'
defined = ['\frac{1}{\lceil x\rceil+x-1}']
[[claim]]
id = 'all'
says = 'test'
defined = ['\frac1x']
[[claim]]
id = 'most'
says = 'test'
assuming = ['x>-1']
defined = ['\frac1x']
",
    );
    for id in ["later", "odd", "leap"] {
        assert!(!matches!(on_motion(&account, id), Outcome::Fails(_)), "{id}");
    }
    for id in ["all", "most"] {
        assert!(matches!(on_motion(&account, id), Outcome::Fails(_)), "{id}");
    }
}

#[test]
fn values_at_several_times_are_joined_by_a_system() {
    let account = file(
        "[system.s]\nstates = ['x']\nequations = ['\\dot x=1']\n\
         [[claim]]\nid = 'right'\nsays = 'test'\nfollows-from = ['s']\nalways = ['x(1)=x(0)+1']\ntrajectories = []\n\
         [[claim]]\nid = 'wrong'\nsays = 'test'\nfollows-from = ['s']\nalways = ['x(1)=x(0)+2']\ntrajectories = []\n\
         [[claim]]\nid = 'free'\nsays = 'test'\nfollows-from = ['s']\nalways = ['x(1)=3']\ntrajectories = []\n",
    );
    // A point that satisfies what is given at each time need belong to no motion.
    assert_ne!(standing(&account, "right"), "refuted");
    assert!(!standing(&account, "wrong").starts_with("proved"));
    assert_eq!(standing(&account, "free"), "refuted");
}

#[test]
fn no_point_where_no_motion_of_a_system_passes_refutes() {
    // What has a sign at the start, and where right sides have values, leads from there; what leads there is the system.
    for (equation, assuming, formula) in [
        (r"\dot x=0", "x(0)>0", "|x|=x"),
        (r"\dot x=x", "x(0)>0", "|x|=x"),
        (r"\dot x=\sqrt x", "", "|x|=x"),
        (r"\dot x=\ln x", "", r"\sqrt{x(0)^2}=x(0)"),
        (r"\dot x=\arcsin x", "", r"\sqrt{(1-x)^2}=1-x"),
        (r"\dot x=-x^2", "", "x(0)-x(1)=x(0)x(1)"),
        (r"\dot x=x", "", "x(2)x(0)=x(1)^2"),
    ] {
        let assuming = if assuming.is_empty() { String::new() } else { format!("assuming = ['{assuming}']\n") };
        let account = file(&format!(
            "[system.s]\nstates = ['x']\nequations = ['{equation}']\n\
             [[claim]]\nid = 'c'\nsays = 'test'\nfollows-from = ['s']\n{assuming}always = ['{formula}']\ntrajectories = []\n"
        ));
        assert_ne!(standing(&account, "c"), "refuted", "{equation}: {formula}");
    }
}

/// What comes of a claim that follows from another one, which has values in a part of space only.
fn following(premise: &str, claim: &str) -> &'static str {
    let account = file(&format!(
        "[[claim]]\nid = 'p'\nsays = 'test'\npostulate = true\n{premise}\ntrajectories = []\n\
         [[claim]]\nid = 'c'\nsays = 'test'\nfollows-from = ['p']\n{claim}\ntrajectories = []\n"
    ));
    standing(&account, "c")
}

#[test]
fn a_claim_that_is_named_says_nothing_where_it_has_no_value() {
    let size = r"always = ['|x|=x']";
    for premise in [
        r"always = ['\sqrt x^2=x']",
        r"always = ['v^2=x']",
        r"always = ['e^{\ln x}=x']",
        r"always = ['\ln(x^2)=2\ln x']",
        r"always = ['v\ge0']",
    ] {
        // On x = −1 the first says nothing.
        assert_eq!(following(premise, size), "proved except", "{premise}");
        for claim in ["never = ['x=-1']", "eventually = ['x=-1']", r"always = ['x\ne-1']"] {
            assert_eq!(following(premise, claim), "undecided", "{premise}, {claim}");
        }
    }
    assert_eq!(following(r"always = ['\frac yx=2']", "always = ['y=2x']"), "proved except");
    assert_eq!(following(r"always = ['\arcsin x=y']", r"always = ['x=\sin y']"), "proved except");
    assert_eq!(following(r"always = ['\sqrt{a}^2=a']", "always = ['|a|=a']"), "proved except");
    // What is needed is assumed, or needed by the claim itself, or the premise is not.
    for claim in [
        "assuming = ['x>0']\nalways = ['|x|=x']",
        r"always = ['\sqrt{x^2}=v^2']",
        "assuming = ['y^2+1=x']\nalways = ['|x|=x']",
        r"always = ['(x+1)^2=x^2+2x+1']",
    ] {
        assert_eq!(following(r"always = ['v^2=x']", claim), "proved", "{claim}");
    }
}
