//! Formulas as textbooks and programs print them: what each means is proved, and what it could be taken for is refuted.

use crate::checked::said_by_prover;
use rederive::check::{Cache, Proposition, prove};
use rederive::derivation::{Derivation, parse};
use rederive::diag::Source;
use rederive::latex::{Declaration, Role};

/// What becomes of a formula: `proved`, `refuted`, `undecided`, or the code with which it is refused.
fn fate(formula: &str, symbols: &str, given: &[&str]) -> String {
    let mut derivation = Derivation::blank();
    let typed: Vec<(String, String)> =
        symbols.split("; ").filter(|s| !s.is_empty()).map(|s| (s.to_owned(), s.to_owned())).collect();
    derivation.declare_typed(&typed).unwrap_or_else(|e| panic!("{symbols}: {e:?}"));
    let given = given.iter().map(|&g| g.to_owned()).collect();
    let proposition = Proposition { formula: formula.to_owned(), given, throughout: false };
    match prove(&mut derivation, &proposition) {
        Ok(account) => said_by_prover(&account).to_owned(),
        Err(rederive::check::CheckError::Problems(found)) => found[0].code.to_owned(),
        Err(other) => panic!("{formula}: {other:?}"),
    }
}

#[track_caller]
fn all(rows: &[(&str, &str, &str)]) {
    let wrong: Vec<String> = rows
        .iter()
        .filter_map(|&(expected, formula, symbols)| {
            let found = fate(formula, symbols, &[]);
            (found != expected).then(|| format!("{formula}: {found} instead of {expected}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{} of {} rows:\n{}", wrong.len(), rows.len(), wrong.join("\n"));
}

#[test]
fn exponents_with_a_slash() {
    all(&[
        ("proved", r"e^{-x^2/4Dt}=\exp(-\frac{x^2}{4Dt})", "x, D, t"),
        ("refuted", r"e^{-x^2/4Dt}=\exp(-\frac{x^2}{4}Dt)", "x, D, t"),
        ("proved", r"e^{-E/kT}=\exp(-\frac{E}{kT})", "E, k, T"),
        ("proved", r"\mathrm e^{-mv^2/2kT}=\exp(-\frac{mv^2}{2kT})", "m, v, k, T"),
        ("proved", r"e^{-x^2/2\sigma^2+x}=\exp(x-\frac{x^2}{2\sigma^2})", r"x, \sigma"),
        ("proved", r"e^{x^{x/a}}=\exp(x^{x/a})", "x, a"),
        // A script of a script, and parentheses, are no place where letters have to touch.
        ("latex::ambiguous", r"e^{x^{x/ab}}=1", "x, a, b"),
        ("latex::ambiguous", r"e^{(x/ab)}=1", "x, a, b"),
        ("latex::ambiguous", r"e^{-1/2x^2}=1", "x"),
        ("latex::ambiguous", r"e^{-a/2x^2}=1", "x, a"),
        ("latex::ambiguous", r"e^{x/a\,b}=1", "x, a, b"),
        ("latex::ambiguous", r"e^{x/a(b+1)}=1", "x, a, b"),
        ("latex::ambiguous", r"e^{x/ab/x}=1", "x, a, b"),
        ("latex::ambiguous", r"e^{x/ab\cdot x}=1", "x, a, b"),
        ("latex::ambiguous", r"2^{x/ab}=1", "x, a, b"),
        ("latex::ambiguous", r"x/ab=1", "x, a, b"),
    ]);
}

#[test]
fn products_with_a_cross() {
    all(&[
        ("proved", r"a\times b\times c=abc", "a, b, c"),
        ("proved", r"3\times10^8a=300000000a", "a"),
        ("proved", r"a\times\frac1a=1", "a: positive"),
        ("latex::shape", r"a\times{\bf v}=0", r"a; {\bf v}: 3"),
        ("latex::ambiguous", r"{\bf u}\times{\bf v}\times{\bf u}=0", r"{\bf u}: 3; {\bf v}: 3"),
        ("latex::shape", r"u_i\times v_i=u_iv_i", r"{\bf u}: 3; {\bf v}: 3"),
        ("latex::ambiguous", r"a/b\times c=1", "a, b, c"),
    ]);
}

#[test]
fn arguments_and_factors() {
    all(&[
        ("proved", r"\cos kx=\cos(kx)", "k, x"),
        ("proved", r"\sin\omega t=\sin(\omega t)", r"\omega, t"),
        ("latex::ambiguous", r"\sin\omega x=1", r"\omega, x"),
        ("latex::ambiguous", r"\cos k\,x=1", "k, x"),
        ("latex::ambiguous", r"\cos kx=1", "k: state; x"),
        ("latex::ambiguous", r"\det AB=1", "A, B: 2x2"),
        ("latex::ambiguous", r"\det AB=1", "A: 2x2; B: state, 2x2"),
        ("proved", r"e^{-\gamma t}(A+Bt)=Ae^{-\gamma t}+Bte^{-\gamma t}", r"t: time; \gamma, A, B"),
        ("latex::ambiguous", r"e^{-x}(A+Bt)=1", r"t: time; x: state; A, B"),
        ("latex::ambiguous", r"e^{-t}(1+2)=1", r"t: time"),
        ("proved", r"\sqrt{\pi^2a^2}=\pi|a|", "a"),
        ("proved", r"\sin(90^{\circ}-x)=\cos x", "x"),
        ("proved", r"\sin30^\circ=\frac12", "x"),
        ("proved", r"360^\circ x=2\pi x", "x"),
        ("refuted", r"\sin(90^\circ+x)=\sin x", "x"),
        ("latex::ambiguous", r"\sin30^\circ x=1", "x"),
        ("latex::double-script", r"x=(30^\circ^2)", "x"),
        ("refuted", r"\sqrt{(1-\pi)^2}=1-\pi", "a"),
        ("refuted", r"\left\lfloor x\right\rfloor=x", "x"),
    ]);
}

/// A space in a comment, or in a label, is on no paper: it ends no argument.
#[test]
fn what_is_not_printed_ends_no_argument() {
    all(&[
        ("proved", r"\sin x\,y=y\sin x", "x: state; y: state"),
        ("latex::ambiguous", r"\sin xy=y\sin x", "x: state; y: state"),
        ("latex::ambiguous", "\\sin x%\\,\ny=y\\sin x", "x: state; y: state"),
        ("latex::ambiguous", r"\sin x\label{\,}y=y\sin x", "x: state; y: state"),
        ("refuted", "\\ln x\\> %\nxy=1", "x: state; y: state"),
    ]);
}

/// Where one part has a value nowhere, or an assumption leaves none, nothing is proved by the others.
#[test]
fn parts_without_a_value() {
    all(&[
        ("undecided", r"(0\ln(-\left|x\right|)+\left|x\right|,\frac{x-3}{x-3})=(\left|x\right|,1)", "x"),
        ("undecided", r"0\ln(-\left|x\right|)+\arcsin x+\arccos x=\frac\pi2", "x"),
        ("undecided", r"0\ln(-x^2)+\ln(ab)=\ln a+\ln b", "x; a, b: positive"),
        ("proved", r"(0\ln\left|x\right|+x,\frac{x-3}{x-3})=(x,1)", "x"),
    ]);
}

/// A second accent is printed above the first.
#[test]
fn accents_on_accents() {
    all(&[
        ("proved", r"\overline{\overline z}=z", "z: complex"),
        ("refuted", r"\overline{\overline z}=z^*", "z: complex"),
        ("proved", r"\bar{\bar z}=z", "z: complex"),
        ("refuted", r"\overline{\bar z}=\bar z", "z: complex"),
        ("proved", r"\bar{\bar{\bar z}}=z^*", "z: complex"),
        ("latex::unknown-symbol", r"\hat{\hat x}=\hat x", r"\hat x"),
        ("proved", r"{\bf{\bf m}}={\bf m}", r"{\bf m}: 3"),
    ]);
}

#[test]
fn differentials_are_rates() {
    let gas = r"U, S, V: state; T, P";
    all(&[
        ("refuted", r"dU=T\,dS-P\,dV", gas),
        ("latex::derivative", r"dU=T\,dS-PV", gas),
        ("latex::derivative", r"dU=TS", gas),
        ("latex::derivative", r"dU\,dS=0", gas),
        ("latex::derivative", r"dU\ge T\,dS", gas),
        ("latex::derivative", r"\sin(dU)=0", gas),
        ("latex::derivative", r"dT=0", gas),
        ("latex::derivative", r"\dot U=dU", gas),
        ("latex::ambiguous", r"dU^2=0", gas),
        ("latex::ambiguous", r"d(US)^2=0", gas),
        ("proved", r"U\,dS=d(US)-S\,dU", gas),
        ("refuted", r"U\,dS=d(US)+S\,dU", gas),
        ("latex::derivative", r"d(d(U))=0", gas),
        ("latex::ambiguous", r"dU(0)=0", gas),
        ("latex::ambiguous", r"\sin V dU=0", gas),
        // Declared, the letter is what it is declared as.
        ("proved", r"dU=Ud", "U: state; d"),
        ("proved", r"dU/dt=\dot U", gas),
        ("proved", r"dU/dS=\frac{\dot U}{\dot S}", gas),
        ("proved", r"T\,dS/dt=T\dot S", gas),
    ]);
    // The first law, and what follows from it at constant volume.
    let law = r"dU=T\,dS-P\,dV";
    assert_eq!(fate(r"\dot U=T\dot S-P\dot V", gas, &[law]), "proved");
    assert_eq!(fate(r"dU=T\,dS", gas, &[law, "dV=0"]), "proved");
    assert_eq!(fate(r"dU=T\,dS", gas, &[law]), "refuted");
    // A function of state: d(xy) = x dy + y dx.
    assert_eq!(fate(r"dF=x\,dy+y\,dx", "x, y: state; F: observable = xy", &[]), "proved");
    assert_eq!(fate(r"dF=x\,dy-y\,dx", "x, y: state; F: observable = xy", &[]), "refuted");
    assert_eq!(fate(r"\mathrm{d}x=v\,\mathrm dt", "x, v: state", &[r"\dot x=v"]), "proved");
}

#[test]
fn what_is_printed_again_means_the_same() {
    let mut derivation = Derivation::blank();
    for (key, role) in [("t", Role::Time), ("x", Role::State), ("y", Role::State), ("a", Role::Parameter)] {
        let declaration = Declaration::of(role);
        derivation.scope.declare(&mut derivation.graph, key, declaration).expect("a name");
    }
    for text in [r"dx=a\,dy", r"\mathrm{d}x=a\,\mathrm{d}t", r"dx/dt=a", r"e^{-x^2/4at}=a\times x\times y"] {
        let chains = rederive::latex::parse(text, &derivation.scope).expect(text);
        let again = rederive::latex::syntax::to_latex(&chains[0]);
        let mut graph = derivation.graph.clone();
        let first = rederive::latex::read(text, &derivation.scope, &mut graph).expect(text);
        let second = rederive::latex::read(&again, &derivation.scope, &mut graph);
        let second = second.unwrap_or_else(|e| panic!("{text}, printed as {again}: {e:?}"));
        let sides = |s: &[rederive::latex::Statement]| {
            s[0].relations.iter().map(|r| (r.left.clone(), r.right.clone())).collect::<Vec<_>>()
        };
        assert_eq!(sides(&first), sides(&second), "{text}, printed as {again}");
    }
}

/// A convention changes what `\log` means: what was found before is not kept.
#[test]
fn a_change_of_the_logarithm_is_noticed() {
    let file = |log: &str| {
        let text = format!(
            "[derivation]\ntitle = \"a\"\nconcerns = \"b\"\n[conventions]\nlog = \"{log}\"\n[symbols]\n't' = {{ role = \"time\" }}\n\
             'x' = {{ role = \"state\" }}\n[[trajectory]]\nid = \"m\"\nformula = {{ 'x' = '2+t' }}\nspan = [0, 1]\n\
             [[claim]]\nid = \"c\"\nsays = \"it\"\nalways = ['\\log x=\\ln x']\n"
        );
        parse(Source { path: "a.toml".into(), text }, "a").expect("a file")
    };
    let mut cache = Cache::default();
    let mut verdict = |log: &str| {
        let derivation = file(log);
        let (account, _) = cache.check(&derivation, None).unwrap_or_else(|e| panic!("{e:?}"));
        rederive::report::json(&derivation, &account)
    };
    let outcome = |json: String| json.contains("\"fails\": 1");
    let (natural, decimal) = (verdict("natural"), verdict("decimal"));
    assert_ne!(outcome(natural), outcome(decimal), "the verdicts differ");
}

#[test]
fn primes_are_derivatives_by_a_variable_that_is_no_time() {
    let curve = "x: time; y: state; a";
    all(&[
        ("proved", r"y'=\frac{dy}{dx}", curve),
        ("proved", r"y''=\frac{d^2y}{dx^2}", curve),
        ("proved", r"y''''=\frac{d^4y}{dx^4}", curve),
        ("proved", r"y'(0)=\left.\frac{dy}{dx}\right|_{x=0}", curve),
        ("proved", r"y'^2=(\frac{dy}{dx})^2", curve),
        ("refuted", r"y''=y'^2", curve),
        ("proved", r"r'=\frac{dr}{d\theta}", r"\theta: time; r: state"),
        // Of a constant, of the variable itself, and beside a time: a name that is not declared.
        ("latex::unknown-symbol", r"a'=0", curve),
        ("latex::unknown-symbol", r"x'=1", curve),
        ("latex::unknown-symbol", r"y'=0", "t: time; y: state"),
        ("latex::unknown-symbol", r"y'=0", r"\tau: time; y: state"),
        // Declared, it is what it is declared as.
        ("refuted", r"y'=\frac{dy}{dx}", "x: time; y, y': state"),
    ]);
}

#[test]
fn names_in_square_brackets() {
    let kinetics = r"[S], [ES]: state; k, S_0, [S]_0";
    all(&[
        ("proved", r"k[S]=[S]k", kinetics),
        ("proved", r"\frac{d[S]}{dt}=\frac{d}{dt}[S]", kinetics),
        ("proved", r"2[S][ES]-[S]([ES]+k)=[S][ES]-k[S]", kinetics),
        ("refuted", r"[S]=[S]_0", kinetics),
        ("refuted", r"d[S]=-k[S]\,dt", kinetics),
        ("proved", r"[{\rm S}]=[\mathrm{S}]", r"[\mathrm{S}]"),
        ("proved", r"[\mathrm{H}^+]^2=[\mathrm{H}^+][\mathrm{H}^+]", r"[\mathrm{H}^+]"),
        ("latex::unknown-symbol", r"[P]=0", kinetics),
        ("proved", r"[k]=k", kinetics),
        ("refuted", r"[S_0]=[S]+[A_{\rm adsorption}]", r"[S_0], [S], [A_{\rm adsorption}]"),
        ("latex::ambiguous", r"[S_0]=1", "[S_0]; S_0"),
        ("proved", r"[A_{12}]-[A_{12}]=0", "[A_{12}]"),
        ("latex::ambiguous", r"[A_12]=0", "[A_{12}]"),
        ("latex::ambiguous", r"[S]=1", "[S]; S"),
    ]);
}

/// A whole part is its number at a whole number, and leaps there.
#[test]
fn whole_parts() {
    all(&[
        ("proved", r"\lfloor\frac72\rfloor+\lceil-\frac72\rceil=0", "x"),
        ("proved", r"\left\lceil{2}\right\rceil^2=4", "x"),
        ("proved", r"\operatorname{floor}(x)=-\operatorname{ceiling}{\left(- x \right)}", "x"),
        ("proved", r"\lfloor x\rfloor y=y\lfloor x\rfloor", "x, y"),
        ("proved", r"\sin(\lfloor x\rfloor)y=y\sin(\left\lfloor x\right\rfloor)", "x: state; y: state"),
        ("refuted", r"\lfloor x\rfloor^2=\lfloor x^2\rfloor", "x"),
        ("refuted", r"\lfloor x\rfloor=x", "x"),
        ("latex::unbalanced", r"\lfloor x\rceil=x", "x"),
        ("latex::unbalanced", r"\lfloor x=x", "x"),
        ("latex::unbalanced", r"\left|\lfloor x\right|\rfloor=x", "x"),
    ]);
}

/// What has no value equals nothing, and is not said to differ from anything.
#[test]
fn a_number_without_a_value() {
    all(&[
        ("undecided", r"\sqrt{-4}=2i", "z: complex"),
        ("undecided", r"\sqrt{-1}=i", "z: complex"),
        ("undecided", r"\frac{i}{0}=2", "z: complex"),
        ("refuted", r"\sqrt3=1+i", "z: complex"),
    ]);
}
