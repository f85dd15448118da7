//! Texts that print the same are read the same: both with one meaning, or both refused.
//!
//! Formulas are made as what a page shows: nuclei with scripts and primes, fractions, roots, fences. Each is spelled twice, by choices that
//! TeX sets alike: braces around arguments or not, the order of scripts, `'` or `^{\prime}`, `\frac12` or `{1\over2}`, switches or
//! commands of style, bars by their commands, letters of Unicode, spaces and comments. The reader is not asked how.

use std::collections::BTreeMap;

use crate::latex_support::{World, shown};
use rederive::expr::Expr;
use rederive::latex::Role;

fn world() -> World {
    use Role::{Coordinate, Observable, Parameter, State, Time};
    World::empty()
        .with("t", Time, "")
        .with("a", Parameter, "")
        .with("b", Parameter, "")
        .with("k", Parameter, "")
        .with("f", Parameter, "")
        .with("S", Parameter, "")
        .with(r"\Gamma", Parameter, "")
        .with("a'", Parameter, "")
        .with("y_p''", Parameter, "")
        .with(r"\theta_0", Parameter, "")
        .with(r"x_{\rm max}", Parameter, "")
        .with("x", State, "")
        .with("y", State, "")
        .with("y'", State, "")
        .with(r"\theta", Observable, "")
        .with(r"{\bf u}", State, "3")
        .with(r"{\bf u}'", State, "3")
        .with(r"\vec q", Parameter, "3")
        .with(r"\vec q'", Parameter, "3")
        .with("R", Parameter, "3x3")
        .with("s", Coordinate, "")
}

/// A reproducible source of numbers (splitmix64).
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n.max(1) as u64) as usize
    }

    fn coin(&mut self) -> bool {
        self.below(2) == 0
    }

    fn pick<'a>(&mut self, of: &[&'a str]) -> &'a str {
        of[self.below(of.len())]
    }
}

/// What a page shows.
#[derive(Clone, Debug)]
enum Print {
    /// One sign; its spellings.
    Sign(&'static [&'static str]),
    /// A nucleus with a subscript, primes, and a superscript behind them.
    Scripts(Box<Print>, Option<Box<Print>>, usize, Option<Box<Print>>),
    Fraction(Box<Print>, Box<Print>),
    Root(Option<&'static str>, Box<Print>),
    Dots(&'static str, Box<Print>),
    Fence(usize, Box<Print>),
    Function(&'static str, Option<Box<Print>>, Box<Print>),
    Rate(Box<Print>),
    Row(Vec<Print>),
}

/// Names, with spellings that print alike.
const NAMES: &[&[&str]] = &[
    &["a"],
    &["b"],
    &["k", "{k}"],
    &["x"],
    &["y"],
    &["f"],
    &["S"],
    &[r"\Gamma", "Γ"],
    &[r"\theta", "θ"],
    &[r"{\bf u}", r"\mathbf{u}", r"\mathbf u", r"\textbf{u}", r"\vb{u}", "𝐮"],
    &[r"\vec q", r"\vec{q}", r"{\vec q}"],
    &["R"],
    &["s"],
];

/// The signs between.
const JOINS: &[&[&str]] =
    &[&["+"], &["-", "−"], &[r"\cdot", "·", "⋅"], &[r"\times", "×"], &[r"\pm", "±"], &[""], &[""], &[""], &[""]];

/// Fences that open and close alike.
const FENCES: &[&[(&str, &str)]] = &[
    &[
        ("(", ")"),
        (r"\left(", r"\right)"),
        (r"\bigl(", r"\bigr)"),
        (r"\Big(", r"\Big)"),
        (r"{(", r")}"),
        (r"\qty(", ")"),
    ],
    &[("[", "]"), (r"\left[", r"\right]"), (r"\lbrack", r"\rbrack")],
    &[
        ("|", "|"),
        (r"\left|", r"\right|"),
        (r"\lvert", r"\rvert"),
        (r"\left\vert", r"\right\vert"),
        (r"\bigl|", r"\bigr|"),
        (r"\abs{", "}"),
    ],
    &[
        (r"\|", r"\|"),
        (r"\left\|", r"\right\|"),
        (r"\lVert", r"\rVert"),
        (r"\Vert", r"\Vert"),
        (r"\left\Vert", r"\right\Vert"),
        (r"\norm{", "}"),
    ],
];

fn boxed(print: Print) -> Box<Print> {
    Box::new(print)
}

fn name(dice: &mut Dice) -> Print {
    Print::Sign(NAMES[dice.below(NAMES.len())])
}

fn digit(dice: &mut Dice) -> Print {
    Print::Sign([&["1"][..], &["2"], &["3"]][dice.below(3)])
}

fn subscript(dice: &mut Dice) -> Print {
    match dice.below(6) {
        0 => Print::Sign(&["0"]),
        1 => Print::Sign(&["p"]),
        2 => Print::Sign(&[r"\rm max", r"\mathrm{max}", r"\text{max}", r"\rm{max}"]),
        3 => Print::Sign(&["i"]),
        4 => Print::Row(vec![digit(dice), digit(dice)]),
        _ => digit(dice),
    }
}

fn superscript(dice: &mut Dice) -> Print {
    match dice.below(5) {
        0 => Print::Row(vec![Print::Sign(&["-", "−"]), digit(dice)]),
        1 => name(dice),
        2 => Print::Sign(&["T"]),
        _ => digit(dice),
    }
}

/// A random atom.
fn atom(dice: &mut Dice, depth: usize) -> Print {
    let within = |dice: &mut Dice| boxed(if depth == 0 { name(dice) } else { row(dice, depth - 1) });
    match dice.below(15) {
        0..=2 => name(dice),
        3..=5 => {
            let nucleus = name(dice);
            let sub = dice.coin().then(|| boxed(subscript(dice)));
            let primes = dice.below(4).saturating_sub(1);
            // A power of a component or a component of a power: where one order is read at all, it says which.
            let is_matrix = matches!(nucleus, Print::Sign(["R"])) && sub.is_some();
            let sup = (dice.below(3) == 0 && !is_matrix).then(|| boxed(superscript(dice)));
            Print::Scripts(boxed(nucleus), sub, primes, sup)
        }
        6 => Print::Fraction(within(dice), within(dice)),
        7 => Print::Fraction(boxed(digit(dice)), boxed(digit(dice))),
        8 => Print::Root(dice.coin().then_some("3"), within(dice)),
        9 => {
            let dotted = Print::Dots([r"\dot", r"\ddot"][dice.below(2)], boxed(name(dice)));
            match dice.below(3) {
                0 => Print::Scripts(boxed(dotted), Some(boxed(subscript(dice))), dice.below(2), None),
                _ => dotted,
            }
        }
        10 | 11 => {
            let fence = Print::Fence(dice.below(FENCES.len()), within(dice));
            match dice.below(3) {
                0 => Print::Scripts(boxed(fence), None, 0, Some(boxed(superscript(dice)))),
                _ => fence,
            }
        }
        12 => {
            let power = dice.coin().then(|| boxed(digit(dice)));
            Print::Function(["sin", "ln"][dice.below(2)], power, within(dice))
        }
        13 => Print::Rate(boxed(name(dice))),
        // A script or a prime behind what is no name.
        _ => {
            let what = if dice.coin() {
                Print::Root(None, boxed(name(dice)))
            } else {
                Print::Fraction(within(dice), within(dice))
            };
            Print::Scripts(boxed(what), None, dice.below(2), dice.coin().then(|| boxed(superscript(dice))))
        }
    }
}

fn row(dice: &mut Dice, depth: usize) -> Print {
    let mut parts = vec![atom(dice, depth)];
    for _ in 0..dice.below(3) {
        parts.push(Print::Sign(JOINS[dice.below(JOINS.len())]));
        parts.push(atom(dice, depth));
    }
    Print::Row(parts)
}

/// How many pairs of bars there are.
fn bars(print: &Print) -> usize {
    let of = |parts: &[&Print]| parts.iter().map(|part| bars(part)).sum::<usize>();
    match print {
        Print::Sign(_) => 0,
        Print::Scripts(nucleus, sub, _, sup) => of(&[nucleus]) + sub.iter().chain(sup).map(|s| bars(s)).sum::<usize>(),
        Print::Fraction(top, bottom) => of(&[top, bottom]),
        Print::Root(_, inner) | Print::Dots(_, inner) | Print::Rate(inner) => bars(inner),
        Print::Fence(kind, inner) => usize::from(*kind >= 2) + bars(inner),
        Print::Function(_, power, inner) => bars(inner) + power.iter().map(|p| bars(p)).sum::<usize>(),
        Print::Row(parts) => parts.iter().map(bars).sum(),
    }
}

/// Joins pieces; a command does not run into a letter.
fn put(out: &mut String, piece: &str, dice: &mut Dice) {
    let tail = out.rsplit('\\').next().unwrap_or_default();
    let command = tail.len() < out.len() && tail.bytes().all(|b| b.is_ascii_alphabetic()) && !tail.is_empty();
    if command && piece.starts_with(|c: char| c.is_ascii_alphabetic()) {
        out.push(' ');
    } else {
        out.push_str(dice.pick(&["", "", "", "", " ", "%\n", r"\relax "]));
    }
    out.push_str(piece);
}

/// What TeX takes as one argument: in braces, or without them where it is one token.
fn argument(print: &Print, bars: usize, dice: &mut Dice) -> String {
    let text = spelled(print, bars, dice);
    let token = text.chars().count() == 1
        || text.strip_prefix('\\').is_some_and(|c| !c.is_empty() && c.bytes().all(|b| b.is_ascii_alphabetic()));
    match dice.below(5) {
        0..=2 if token => text,
        3 => format!("{{{{{text}}}}}"),
        _ => format!("{{{text}}}"),
    }
}

/// One of the ways in which it is written.
fn spelled(print: &Print, bars: usize, dice: &mut Dice) -> String {
    let mut out = String::new();
    match print {
        Print::Sign(spellings) => out.push_str(dice.pick(spellings)),
        Print::Row(parts) => {
            for part in parts {
                let piece = spelled(part, bars, dice);
                let operator = matches!(part, Print::Sign(of) if JOINS.contains(of));
                let piece = match dice.below(16) {
                    0 if !operator => format!(r"\ensuremath{{{piece}}}"),
                    1 if !operator => format!(r"\textcolor{{black}}{{{piece}}}"),
                    2 => format!(r"\color{{black}}{piece}"),
                    3 => format!(r"\phantom{{}}{piece}"),
                    _ => piece,
                };
                put(&mut out, &piece, dice);
            }
        }
        Print::Scripts(nucleus, sub, primes, sup) => {
            out = spelled(nucleus, bars, dice);
            // A nucleus in braces has its scripts behind it as without them.
            let single = matches!(**nucleus, Print::Sign(_) | Print::Dots(..) | Print::Fence(..));
            if single && dice.below(4) == 0 {
                out = format!("{{{out}}}");
            }
            let prime = dice.pick(&["'", "'", "′"]);
            let above = match (primes, sup) {
                (0, None) => String::new(),
                (0, Some(sup)) => format!("^{}", argument(sup, bars, dice)),
                (1, None) if dice.coin() => dice.pick(&[r"^\prime", r"^{\prime}"]).to_owned(),
                (n, None) if dice.coin() => format!("^{{{}}}", r"\prime".repeat(*n)),
                (n, None) => prime.repeat(*n),
                (n, Some(sup)) if dice.coin() => format!("^{{{} {}}}", r"\prime".repeat(*n), spelled(sup, bars, dice)),
                (n, Some(sup)) => format!("{}^{}", prime.repeat(*n), argument(sup, bars, dice)),
            };
            let below = sub.as_ref().map(|sub| format!("_{}", argument(sub, bars, dice))).unwrap_or_default();
            for script in if dice.coin() { [below, above] } else { [above, below] } {
                put(&mut out, &script, dice);
            }
        }
        Print::Fraction(top, bottom) => match dice.below(4) {
            0 => out = format!(r"{{{}\over {}}}", spelled(top, bars, dice), spelled(bottom, bars, dice)),
            n => {
                out.push_str([r"\frac", r"\tfrac", r"\dfrac"][n - 1]);
                for part in [top, bottom] {
                    let piece = argument(part, bars, dice);
                    put(&mut out, &piece, dice);
                }
            }
        },
        Print::Root(degree, of) => {
            out.push_str(r"\sqrt");
            if let Some(degree) = degree {
                out.push_str(&format!("[{degree}]"));
            }
            let piece = argument(of, bars, dice);
            put(&mut out, &piece, dice);
        }
        Print::Dots(command, of) => {
            out.push_str(command);
            let piece = argument(of, bars, dice);
            put(&mut out, &piece, dice);
        }
        Print::Fence(kind, of) => {
            // Which of several bars belong together is seen where they say their side.
            let sided: Vec<_> = FENCES[*kind].iter().filter(|f| bars == 1 || *kind < 2 || f.0 != f.1).collect();
            let (open, close) = *sided[dice.below(sided.len())];
            out.push_str(open);
            for piece in [&*spelled(of, bars, dice), close] {
                put(&mut out, piece, dice);
            }
        }
        Print::Function(name, power, of) => {
            let operator = format!(r"\operatorname{{{name}}}");
            out.push_str(if dice.coin() { &operator } else { "" });
            if out.is_empty() {
                out = format!(r"\{name}");
            }
            let power = power.as_ref().map(|power| format!("^{}", argument(power, bars, dice))).unwrap_or_default();
            let of = format!("({})", spelled(of, bars, dice));
            for piece in [power, of] {
                put(&mut out, &piece, dice);
            }
        }
        Print::Rate(of) => {
            let of = spelled(of, bars, dice);
            out = match dice.below(5) {
                0 => format!(r"\frac{{\mathrm d{of}}}{{\mathrm dt}}"),
                1 => format!(r"\frac{{{{\rm d}}{of}}}{{{{\rm d}}t}}"),
                2 => format!(r"\frac{{\text{{d}} {of}}}{{\mathrm{{d}}t}}"),
                3 => format!(r"\dv{{{of}}}{{t}}"),
                _ => format!(r"{{\mathrm{{d}}{of}\over\mathrm{{d}}t}}"),
            };
        }
    }
    out
}

/// What a text means, or why it is refused.
fn meaning(w: &mut World, text: &str) -> Result<Vec<Expr>, String> {
    match w.try_expression(text) {
        Ok(t) => Ok(t.components),
        Err(problems) => Err(shown(text, &problems)),
    }
}

#[test]
fn what_prints_the_same_is_read_the_same() {
    let mut w = world();
    let mut dice = Dice(42);
    let rounds = if std::env::var_os("REDERIVE_LONG").is_some() { 300_000 } else { 6_000 };
    let (mut read, mut refused) = (0, 0);
    // The shortest text for each way to be wrong.
    let mut wrong: BTreeMap<String, String> = BTreeMap::new();
    let mut note = |kind: &str, text: String| {
        let known = wrong.entry(kind.to_owned()).or_insert_with(|| text.clone());
        if text.len() < known.len() {
            *known = text;
        }
    };
    for _ in 0..rounds {
        let print = row(&mut dice, 2);
        let bars = bars(&print);
        let (one, other) = (spelled(&print, bars, &mut dice), spelled(&print, bars, &mut dice));
        if one == other {
            continue;
        }
        match (meaning(&mut w, &one), meaning(&mut w, &other)) {
            (Ok(a), Ok(b)) => {
                if a != b {
                    note("meanings", format!("`{one}` and `{other}` print the same, and have two meanings"));
                }
                read += 1;
            }
            (Err(_), Err(_)) => refused += 1,
            (Ok(_), Err(why)) | (Err(why), Ok(_)) => {
                let kind = why.lines().find(|line| line.contains("latex::")).unwrap_or_default();
                let kind = kind.split(" at ").next().unwrap_or_default();
                note(kind, format!("`{one}` and `{other}` print the same, and one is refused: {why}"));
            }
        }
    }
    let wrong: Vec<String> = wrong.into_values().collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(read > 300 && refused > 300, "{read} pairs were read, {refused} refused");
}

/// Names that print as functions, and what stands in their brackets.
const CALLED: &[&str] = &["f", r"\hat f", "f_1", "f'", r"{\bf f}", r"\Gamma", r"\delta", r"\Theta", r"\zeta", r"\wp"];

#[test]
fn a_call_is_no_product() {
    use Role::{Coordinate, Parameter, State, Time};
    let mut w = World::empty().with("t", Time, "").with("x", State, "").with("s", Coordinate, "");
    for name in CALLED.iter().chain(&["S", "E", r"\mathbb{E}", r"\mathcal{S}", "C", "X", "q", "a", "g", "m", "L", r"u"])
    {
        w = w.with(name, Parameter, "");
    }
    let mut refused = |text: &str| match w.try_expression(text) {
        Err(problems) => {
            assert!(problems[0].code == "latex::ambiguous", "{}", shown(text, &problems));
            problems[0].hint.clone().unwrap_or_default()
        }
        Ok(t) => {
            panic!("`{text}` is read as {:?}", t.components.iter().map(|e| w.graph.to_latex(*e)).collect::<Vec<_>>())
        }
    };
    for name in CALLED {
        for inside in ["a+1", "x-a", "-a", "2a", "a^2", "a/2", r"\frac a2", "a,q", r"\sqrt a", "(a+q)^2", "2", "x", "t"]
        {
            for (open, close) in [("(", ")"), (r"\left(", r"\right)"), (r"{\left(", r"\right)}")] {
                refused(&format!("{name}{open}{inside}{close}"));
            }
        }
    }
    for name in ["S", "E", r"\mathbb{E}", r"\mathcal{S}", "C", "L"] {
        for inside in ["q", "X^2", "q_1", r"\dot x", "2X", "(X-a)^2", "f(a)"] {
            refused(&format!("{name}[{inside}]"));
        }
    }
    for text in
        ["E[X+a]", "S[q+a]", r"\mathbb{E}[(X-a)^2+q]", "L(q,x,t)", r"L(q,\dot x,t)", "u(0,t)", "g(-a)", r"\dot f(a+1)"]
    {
        refused(text);
    }
    // The hint of a refusal is read, and as a product.
    let hint = refused(r"\Gamma(a+1)");
    assert!(hint.contains(r"\Gamma\cdot(a+1)"), "{hint}");
    for (text, means) in [
        (r"\Gamma\cdot(a+1)", r"\Gamma\cdot (a+1)"),
        (r"f\,(a+1)", r"f\cdot (a+1)"),
        ("m(a+q)", r"m\cdot (a+q)"),
        ("g(a-q)", r"g\cdot (a-q)"),
        (r"\zeta(1-\zeta)", r"\zeta\cdot (1-\zeta)"),
        ("2(a+q)", r"2\cdot (a+q)"),
        ("m[a+(q+1)^2]", r"m\cdot (a+(q+1)^{2})"),
        (r"m(\dot x)^2", r"m\cdot \dot{x}^2"),
    ] {
        let t = w.expression(text);
        assert_eq!(w.graph.to_latex(t.components[0]), means, "{text}");
    }
}

#[test]
fn what_is_no_field_has_no_gradient() {
    let mut w = World::empty().with("s", Role::Coordinate, "").with("a", Role::Parameter, "").by(
        "h",
        Role::Abbreviation,
        "a+1",
    );
    for text in [
        r"\operatorname{grad}a",
        r"\mathrm{grad}(a+1)",
        r"{\rm grad}\,h",
        r"\nabla a",
        r"\nabla^2a",
        r"\nabla h",
        r"\nabla(a+1)",
        r"\grad a",
        "∇a",
    ] {
        let problems = w.try_expression(text).expect_err(text);
        assert_eq!(problems[0].code, "latex::derivative", "{}", shown(text, &problems));
    }
    assert!(w.try_expression(r"\nabla(as)").is_ok());
}

#[test]
fn what_is_missing_has_a_name() {
    let mut w = World::empty().with("x", Role::Parameter, "").with("a", Role::Parameter, "");
    for (text, name) in [
        (r"x=\int a", "integral"),
        (r"x=a\oint a", "integral"),
        (r"x\approx a", "approximation"),
        (r"\sin x\approx a", "approximation"),
        ("x≈a", "approximation"),
        (r"x\ll a", "approximation"),
        (r"\sum x=a", "sum"),
        ("∑x=a", "sum"),
        (r"\langle x\rangle=a", "bra-ket"),
        (r"\ket{x}=a", "bra-ket"),
        (r"x\in a", "set"),
        (r"x=\infty", "infinity"),
        (r"x\Rightarrow a", "implication"),
    ] {
        let problems = w.try_read(text).expect_err(text);
        let feature = rederive::latex::feature(text, &problems[0]).map(|f| f.name);
        assert_eq!(feature, Some(name), "{}", shown(text, &problems));
    }
}

#[test]
fn braces_that_print_nothing_and_upright_transposes() {
    let mut w = World::empty()
        .with("t", Role::Time, "")
        .with("a", Role::Parameter, "")
        .with("x", Role::State, "")
        .with("s", Role::Coordinate, "")
        .with("g(s)", Role::Field, "")
        .with("R", Role::Parameter, "3x3")
        .with(r"{\bf u}", Role::State, "3");
    let pairs = [
        (r"\frac{d{}}{dt}(ax)", r"\frac{d}{dt}(ax)"),
        (r"\frac{d^2{}}{dt^2}(ax)", r"\frac{d^2}{dt^2}(ax)"),
        (r"\frac{\partial{}}{\partial{s}}g", r"\frac{\partial}{\partial s}g"),
        (r"{}a+{}x", "a+x"),
        (r"\nicefrac12+\sfrac ax+\cfrac1{a}", r"\frac12+\frac ax+\frac1a"),
        (r"a+\cancelto{0}{x}a", "a+xa"),
        (r"R^{\rm T}", r"R^T"),
        (r"R^\mathrm{T}", r"R^T"),
        (r"R^{\text{T}}", r"R^T"),
        (r"R^{{\mathsf{T}}}", r"R^T"),
        (r"R^\intercal", r"R^\top"),
        (r"{\bf u}^{\rm T}R{\bf u}", r"{\bf u}^TR{\bf u}"),
        (r"\begin{psmallmatrix}a&1\\0&a\end{psmallmatrix}", r"\begin{pmatrix}a&1\\0&a\end{pmatrix}"),
    ];
    for (one, other) in pairs {
        let other = w.expression(other);
        assert_eq!(w.expression(one), other, "{one}");
    }
    // What could be an argument stays.
    for text in [r"\frac a{}x", r"\sqrt{}x"] {
        assert!(w.try_expression(text).is_err(), "{text}");
    }
}
