//! Complex numbers: values of their functions, what is proved of them and what is refuted.

use crate::checked::said_by_prover;
use crate::latex_support::World;
use rederive::check::{Proposition, prove};
use rederive::derivation::Derivation;
use rederive::expr::{Leaf, Part};
use rederive::latex::Role;
use rederive::tape::Tape;

/// A scope with complex z and w, and real x.
fn world() -> World {
    let complex = World::empty().with("t", Role::Time, "").with("x", Role::Parameter, "");
    complex.with("z", Role::Parameter, "complex").with("w", Role::State, "complex")
}

/// Real and imaginary part of a formula where z has a value; `None` where there is none.
fn value(text: &str, z: (f64, f64)) -> Option<(f64, f64)> {
    let mut w = world();
    let t = w.expression(text);
    let leaves = w.graph.leaves(t.components.iter().copied());
    let tape = Tape::compile(&w.graph, &leaves, &t.components).unwrap_or_else(|l| panic!("no input {l:?}"));
    let mut slots = tape.slots::<f64>(&());
    let input = |leaf: &Leaf| match w.graph.part(*leaf) {
        Some(Part::Real) => Ok(z.0),
        Some(Part::Imaginary) => Ok(z.1),
        None => panic!("{text} has a real symbol"),
    };
    let inputs: Vec<_> = leaves.iter().map(input).collect();
    let found: Vec<Option<f64>> = tape.evaluate(&(), &inputs, &mut slots).into_iter().map(Result::ok).collect();
    match *found.as_slice() {
        [Some(re), Some(im)] if re.is_finite() && im.is_finite() => Some((re, im)),
        [_, _] => None,
        _ => panic!("{text} is no complex number"),
    }
}

/// Principal values from mpmath 1.3, at z = −0.7 + 0.4i, 1.3 − 2.1i and 0.3 + 0.2i.
const POINTS: [(f64, f64); 3] = [(-0.7, 0.4), (1.3, -2.1), (0.3, 0.2)];

const VALUES: [(&str, [(f64, f64); 3]); 29] = [
    (
        r"e^z",
        [
            (0.45738535351734033, 0.19337942581728831),
            (-1.8524301292688135, -3.1673712525024307),
            (1.3229515021098726, 0.26817554596894383),
        ],
    ),
    (
        r"\ln z",
        [
            (-0.21539145804622714, 2.62244653934327),
            (0.9041443855896328, -1.0164888305933455),
            (-1.0201104142632773, 0.5880026035475675),
        ],
    ),
    (
        r"\sqrt z",
        [
            (0.23046233404816388, 0.8678207691769814),
            (1.3729198459935112, -0.7647933730903053),
            (0.5746978021301278, 0.1740044935431251),
        ],
    ),
    (
        r"\sqrt[3]z",
        [
            (0.5971962052641104, 0.7138597885853001),
            (1.2748716507900226, -0.44929100911930475),
            (0.698116535236313, 0.13861098491726537),
        ],
    ),
    (
        r"z^z",
        [
            (-0.1400727635183742, -0.38245670730113396),
            (-0.3820030217905532, 0.030066680442834403),
            (0.6544139598312937, -0.01808036376827149),
        ],
    ),
    (
        r"2^z",
        [
            (0.592063105780372, 0.16849457083627212),
            (0.2829974961099798, -2.445971930181758),
            (1.2193332064224054, 0.17012671226486983),
        ],
    ),
    (r"z^5", [(0.29113, 0.17684), (33.23788, 85.68084), (-0.00597, 0.00122)]),
    (
        r"z^{-2}",
        [
            (0.7810650887573964, 1.3254437869822486),
            (-0.07309862940069874, 0.14673474872346143),
            (2.9585798816568047, -7.100591715976331),
        ],
    ),
    (
        r"z^{3/2}",
        [
            (-0.5084519415045072, -0.5152896048046214),
            (0.17872971630192364, -3.877363061603771),
            (0.1376084419304133, 0.16714090848896307),
        ],
    ),
    (
        r"\frac{z^2}{z+i}",
        [
            (-0.4142857142857143, -0.02857142857142857),
            (0.8517241379310345, -3.4793103448275864),
            (0.10392156862745099, -0.01568627450980392),
        ],
    ),
    (r"\bar zz^2", [(-0.455, 0.26), (7.93, -12.81), (0.039, 0.026)]),
    (
        r"\sin z",
        [
            (-0.6964459431223345, 0.31416070729921625),
            (3.993286878281138, -1.0758419674229862),
            (0.30145033842891145, 0.19234362980219283),
        ],
    ),
    (
        r"\cos z",
        [
            (0.8268497574897535, 0.2646139133561924),
            (1.1085989185382097, 3.875292984481024),
            (0.9745069929868755, -0.05949885707931209),
        ],
    ),
    (
        r"\tan z",
        [
            (-0.6537404565414447, 0.5891632952797335),
            (0.015864619573232916, -1.0259093684271858),
            (0.29618134067838103, 0.21545877307378405),
        ],
    ),
    (
        r"\cot z",
        [
            (-0.844091569047697, -0.7607113271969492),
            (0.015069811803063039, 0.9745119344230477),
            (2.207905035537344, -1.6061528688158477),
        ],
    ),
    (
        r"\sec z",
        [
            (1.0970526887431675, -0.3510860376951369),
            (0.06823454238254588, -0.23852525829903126),
            (1.0223488358849635, 0.06241985712701783),
        ],
    ),
    (
        r"\csc z",
        [
            (-1.1930880510646007, -0.5381916424299695),
            (0.23347399258591917, 0.06290084513884282),
            (2.3575049754217874, -1.5042313988189122),
        ],
    ),
    (
        r"\sinh z",
        [
            (-0.698701858450709, 0.48878583348999904),
            (-0.8574217575879888, -1.7013116244795015),
            (0.2984501618819517, 0.20767670305628436),
        ],
    ),
    (
        r"\cosh z",
        [
            (1.1560872119680492, -0.2954064076727107),
            (-0.9950083716808246, -1.4660596280229294),
            (1.0245013402279206, 0.06049884291265949),
        ],
    ),
    (
        r"\tanh z",
        [
            (-0.6687378988996259, 0.25191557357137606),
            (1.0662532471222281, 0.1388136919812298),
            (0.30222912890777215, 0.18486280400641456),
        ],
    ),
    (
        r"\coth z",
        [
            (-1.309525716628618, -0.49330226768033136),
            (0.9222325851234704, -0.12006388759133838),
            (2.407879768107777, -1.4728143751443408),
        ],
    ),
    (
        r"\operatorname{sech}z",
        [
            (0.8119715627876546, 0.20747708305429036),
            (-0.3169449863039669, 0.4669912957009555),
            (0.9726927054337471, -0.05743943992814533),
        ],
    ),
    (
        r"\operatorname{csch}z",
        [
            (-0.9609487270791804, -0.6722439890857774),
            (-0.23622820362785732, 0.4687282370726889),
            (2.257529453173525, -1.5709030644552857),
        ],
    ),
    (
        r"\arcsin z",
        [
            (-0.6728437421520389, 0.4914513634673895),
            (0.5196553085262129, -1.6168668341633212),
            (0.2980343998431547, 0.20772637624812304),
        ],
    ),
    (
        r"\arccos z",
        [
            (2.243640068946936, -0.4914513634673895),
            (1.0511410182686838, 1.6168668341633212),
            (1.2727619269517418, -0.20772637624812304),
        ],
    ),
    (
        r"\arctan z",
        [
            (-0.6629088318340163, 0.26465173851360263),
            (1.335066351764443, -0.3400229971814666),
            (0.3018746666987182, 0.18499462006101108),
        ],
    ),
    (
        r"\operatorname{asinh}z",
        [
            (-0.6845537669693974, 0.32746795378726284),
            (1.5807643635001964, -0.977861559814895),
            (0.30107353944664245, 0.19245144716045312),
        ],
    ),
    (
        r"\operatorname{acosh}z",
        [
            (0.4914513634673895, 2.243640068946936),
            (1.6168668341633212, -1.0511410182686838),
            (0.20772637624812304, 1.2727619269517418),
        ],
    ),
    (
        r"\operatorname{atanh}z",
        [
            (-0.6253589879348027, 0.5791929425987546),
            (0.19201212218326577, -1.226334132687466),
            (0.2957499202364143, 0.21547449370018826),
        ],
    ),
];

#[test]
fn functions_have_their_principal_values() {
    for (text, wanted) in VALUES {
        for (z, wanted) in POINTS.iter().zip(wanted) {
            let Some(found) = value(text, *z) else { panic!("{text} at {z:?} has no value") };
            let size = 1.0 + wanted.0.hypot(wanted.1);
            let error = (found.0 - wanted.0).hypot(found.1 - wanted.1);
            assert!(error < 1e-13 * size, "{text} at {z:?}: {found:?}, not {wanted:?}");
        }
    }
}

#[test]
fn on_a_cut_there_is_no_value() {
    for (text, z) in [
        (r"\ln z", (-1.0, 0.0)),
        (r"\ln z", (0.0, 0.0)),
        (r"\sqrt z", (-4.0, 0.0)),
        (r"z^{1/3}", (-1.0, 0.0)),
        (r"z^z", (-1.0, 0.0)),
        (r"\arcsin z", (2.0, 0.0)),
        (r"\arccos z", (-2.0, 0.0)),
        (r"\arctan z", (0.0, 2.0)),
        (r"\operatorname{asinh}z", (0.0, -2.0)),
        (r"\operatorname{acosh}z", (0.5, 0.0)),
        (r"\operatorname{atanh}z", (3.0, 0.0)),
        (r"\frac1z", (0.0, 0.0)),
        (r"z^{-2}", (0.0, 0.0)),
        // A part by itself has no value, either, where the number has none.
        (r"\operatorname{Re}(\ln z)+0z", (-1.0, 0.0)),
        (r"\operatorname{Re}(\sqrt z)+0z", (-1.0, 0.0)),
        (r"0\ln z", (-1.0, 0.0)),
        (r"(i-i)\ln z", (-1.0, 0.0)),
    ] {
        assert_eq!(value(text, z), None, "{text} at {z:?}");
    }
    // Beside it there is one, on either side another.
    for y in [1e-3, -1e-3] {
        let (_, im) = value(r"\ln z", (-1.0, y)).unwrap_or_else(|| panic!("ln beside the cut"));
        assert!((im - y.signum() * std::f64::consts::PI).abs() < 2e-3, "{im}");
    }
}

fn decision(formula: &str, given: &[&str], symbols: &[&str]) -> &'static str {
    let mut derivation = Derivation::blank();
    derivation.scope.set_imaginary();
    let typed: Vec<(String, String)> = symbols.iter().map(|s| ("symbol".to_owned(), (*s).to_owned())).collect();
    derivation.declare_typed(&typed).unwrap_or_else(|found| panic!("{formula}: {found:?}"));
    let given = given.iter().map(|g| (*g).to_owned()).collect();
    let proposition = Proposition { formula: formula.to_owned(), given, throughout: false };
    let account = prove(&mut derivation, &proposition).unwrap_or_else(|e| panic!("{formula}: {e:?}"));
    said_by_prover(&account)
}

const SYMBOLS: [&str; 3] = ["z, w: complex", "a, b, x, \\varphi", "u: state, complex"];

#[test]
fn identities_are_proved() {
    for formula in [
        r"e^{i\pi}=-1",
        r"\mathrm{i}^2=-1",
        r"|zw|=|z||w|",
        r"|w\cdot z|=|w|\cdot|z|",
        r"|z/w|=\frac{|z|}{|w|}",
        r"|z^3|=|z|^3",
        r"\overline{zw}=\bar z\bar w",
        r"\overline{z/w}=\frac{z^*}{w^*}",
        r"|e^{i\varphi}|=1",
        r"e^{i\varphi}=\cos\varphi+i\sin\varphi",
        r"(\cos\varphi+i\sin\varphi)^5=\cos5\varphi+i\sin5\varphi",
        r"z\bar z=|z|^2",
        r"e^{z+w}=e^ze^w",
        r"e^{\ln z}=z",
        r"\sqrt z\sqrt z=z",
        r"\sin^2z+\cos^2z=1",
        r"\cos(iz)=\cosh z",
        r"z=|z|e^{i\arg z}",
        r"\Re(zw)=\Re z\Re w-\Im z\Im w",
        r"\frac{1}{z}=\frac{\bar z}{|z|^2}",
        r"\ln i=\frac{i\pi}{2}",
        r"\frac{d}{dt}|u|^2=2\Re(\bar u\dot u)",
        r"\frac{d}{dt}u^*=\overline{\dot u}",
    ] {
        assert_eq!(decision(formula, &[], &SYMBOLS), "proved", "{formula}");
    }
}

#[test]
fn what_holds_on_a_part_of_the_plane_is_refuted() {
    for formula in [
        r"\ln(zw)=\ln z+\ln w",
        r"\sqrt{zw}=\sqrt z\sqrt w",
        r"(z^a)^b=z^{ab}",
        r"\sqrt{z^2}=z",
        r"\ln e^z=z",
        r"\arg(zw)=\arg z+\arg w",
        r"(e^{i\varphi})^{1/2}=e^{i\varphi/2}",
        r"|e^{iz}|=1",
        r"|z+w|=|z|+|w|",
        r"\overline{zw}=\bar zw",
        r"z^2=|z|^2",
        r"z^*=z",
        r"\frac{d}{dt}|u|^2=2\bar u\dot u",
    ] {
        assert_eq!(decision(formula, &[], &SYMBOLS), "refuted", "{formula}");
    }
    // No sum of squares of complex numbers is several equations.
    assert_eq!(decision("z=0", &["z^2+w^2=0"], &SYMBOLS), "refuted");
    assert_eq!(decision("z=0", &[r"z\bar z=0"], &SYMBOLS), "proved");
    // An `i` that is declared is what it is declared as.
    assert_eq!(decision("i^2=-1", &[], &["i"]), "refuted");
}

#[test]
fn real_formulas_stay_real() {
    let mut w = world();
    for text in [r"\sqrt{x}", r"\ln x", r"x^{1/3}", r"\arcsin x"] {
        assert!(!w.expression(text).shape.is_complex(), "{text}");
    }
    assert_ne!(decision(r"\sqrt{-1}=i", &[], &SYMBOLS), "proved");
    assert_ne!(decision(r"\ln(-1)=i\pi", &[], &SYMBOLS), "proved");
}

#[test]
fn what_is_not_clear_is_refused() {
    let mut w = world().with("p", Role::Parameter, "").with(r"{\bf v}", Role::State, "3");
    for (text, code) in [
        (r"z<w", "latex::shape"),
        (r"z\bar z\ge0", "latex::shape"),
        (r"x^*=x", "latex::ambiguous"),
        (r"\overline{x+p}=x", "latex::ambiguous"),
        (r"\bar x=x", "latex::unknown-symbol"),
        (r"\frac{d w}{d z}=1", "latex::derivative"),
        (r"iv_i=0", "latex::ambiguous"),
        (r"w(z)=0", "latex::shape"),
        (r"\operatorname{atan2}(z,x)=0", "latex::shape"),
        (r"\operatorname{sgn}z=1", "latex::shape"),
        (r"z^{**}=z", "latex::unexpected"),
    ] {
        match w.try_read(text) {
            Ok(_) => panic!("{text} is read"),
            Err(problems) => assert_eq!(problems[0].code, code, "{text}: {}", problems[0].message),
        }
    }
    // Without anything complex an `i` is not known.
    let mut real = World::empty().with("x", Role::Parameter, "");
    let problems = real.try_read("x=i").expect_err("`i` is not declared");
    assert_eq!(problems[0].code, "latex::unknown-symbol");
    assert!(problems[0].hint.as_deref().is_some_and(|h| h.contains(r"\mathrm{i}")));
}

#[test]
fn the_derivation_with_complex_amplitudes_is_as_expected() {
    let path = format!("{}/derivations/rabi.toml", env!("CARGO_MANIFEST_DIR"));
    let derivation = rederive::derivation::load(std::path::Path::new(&path))
        .unwrap_or_else(|found| panic!("{}", rederive::diag::render(&found, false)));
    let account = rederive::check::check(&derivation, &rederive::check::Options::default(), &|_, _| {});
    let account = account.unwrap_or_else(|e| panic!("{e:?}"));
    for claim in &account.claims {
        for judged in claim.verdicts() {
            let word = judged.verdict.outcome().word();
            assert!(!judged.unexpected, "{} {:?} on {}: {word}", claim.id, claim.reading, judged.on());
        }
    }
    assert_eq!(account.summary().fails, 3);
}
