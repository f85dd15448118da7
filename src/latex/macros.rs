//! Commands that are short for others: of layout, of plain TeX, and of packages, by what they print.
//!
//! A row has the name of a command, what stands behind it, and what it prints. An author's own commands are written out before a formula
//! comes here, so they win.

/// What a command prints.
#[derive(Clone, Copy, Debug)]
pub(super) struct Macro {
    /// Its name.
    pub name: &'static str,
    /// Its arguments in braces, or one token each.
    pub arguments: usize,
    /// Whether the first argument may be missing: it is one only where a brace opens.
    pub may_lack: bool,
    /// What it prints: `#1` is the first argument.
    pub prints: &'static str,
}

const fn of(name: &'static str, arguments: usize, prints: &'static str) -> Macro {
    Macro { name, arguments, may_lack: false, prints }
}

/// An operator that may have what it acts on in braces.
const fn before(name: &'static str, prints: &'static str) -> Macro {
    Macro { name, arguments: 1, may_lack: true, prints }
}

/// The table. A star behind a command, and an option in square brackets behind one that is marked in [`OPTIONS`], are left out.
const MACROS: &[Macro] = &[
    // Layout: what is wrapped is kept, what is not printed is not.
    of("cancel", 1, "{#1}"),
    of("bcancel", 1, "{#1}"),
    of("xcancel", 1, "{#1}"),
    // An arrow to what becomes of it is a remark.
    of("cancelto", 2, "{#2}"),
    of("boxed", 1, "{#1}"),
    of("fbox", 1, "{#1}"),
    of("ensuremath", 1, "#1"),
    of("smash", 1, "{#1}"),
    of("mathclap", 1, "{#1}"),
    of("mathllap", 1, "{#1}"),
    of("mathrlap", 1, "{#1}"),
    of("underbrace", 1, "{#1}"),
    of("overbrace", 1, "{#1}"),
    of("underbracket", 1, "{#1}"),
    of("overbracket", 1, "{#1}"),
    of("textcolor", 2, "{#2}"),
    of("mathcolor", 2, "{#2}"),
    of("color", 1, ""),
    of("phantom", 1, ""),
    of("hphantom", 1, ""),
    of("vphantom", 1, ""),
    of("mathrel", 1, "#1"),
    of("mathbin", 1, "#1"),
    of("mathord", 1, "{#1}"),
    of("mathopen", 1, "#1"),
    of("mathclose", 1, "#1"),
    of("mathpunct", 1, "#1"),
    of("mathinner", 1, "{#1}"),
    of("lbrack", 0, "["),
    of("rbrack", 0, "]"),
    of("lparen", 0, "("),
    of("rparen", 0, ")"),
    of("lbrace", 0, r"\{"),
    of("rbrace", 0, r"\}"),
    of("cfrac", 0, r"\frac"),
    of("nicefrac", 0, r"\frac"),
    of("sfrac", 0, r"\frac"),
    of("flatfrac", 2, r"{#1}/{#2}"),
    of("degree", 0, r"^\circ"),
    of("hslash", 0, r"\hbar"),
    of("triangleq", 0, r"\equiv"),
    of("coloneq", 0, "="),
    of("eqdef", 0, "="),
    of("pmatrix", 1, r"\begin{pmatrix}#1\end{pmatrix}"),
    // The package physics.
    of("abs", 1, r"\left|#1\right|"),
    of("absolutevalue", 1, r"\left|#1\right|"),
    of("norm", 1, r"\left\lVert#1\right\rVert"),
    of("vb", 1, r"\mathbf{#1}"),
    of("vectorbold", 1, r"\mathbf{#1}"),
    of("va", 1, r"\vec{#1}"),
    of("vectorarrow", 1, r"\vec{#1}"),
    of("vu", 1, r"\hat{#1}"),
    of("vectorunit", 1, r"\hat{#1}"),
    of("vdot", 0, r"\cdot"),
    of("dotproduct", 0, r"\cdot"),
    of("cross", 0, r"\times"),
    of("crossproduct", 0, r"\times"),
    of("cp", 0, r"\times"),
    before("grad", r"\nabla #1"),
    before("gradient", r"\nabla #1"),
    before("divergence", r"\nabla\cdot #1"),
    before("curl", r"\nabla\times #1"),
    before("laplacian", r"\nabla^2 #1"),
    before("dd", r"\mathrm{d}#1"),
    before("differential", r"\mathrm{d}#1"),
    of("comm", 2, r"\left[#1,#2\right]"),
    of("commutator", 2, r"\left[#1,#2\right]"),
    of("acomm", 2, r"\left\{#1,#2\right\}"),
    of("anticommutator", 2, r"\left\{#1,#2\right\}"),
    of("pb", 2, r"\left\{#1,#2\right\}"),
    of("poissonbracket", 2, r"\left\{#1,#2\right\}"),
    of("pmqty", 1, r"\begin{pmatrix}#1\end{pmatrix}"),
    of("bmqty", 1, r"\begin{bmatrix}#1\end{bmatrix}"),
    of("Tr", 0, r"\operatorname{tr}"),
    of("tr", 0, r"\operatorname{tr}"),
    of("trace", 0, r"\operatorname{tr}"),
    of("sech", 0, r"\operatorname{sech}"),
    of("csch", 0, r"\operatorname{csch}"),
    of("asin", 0, r"\arcsin"),
    of("acos", 0, r"\arccos"),
    of("atan", 0, r"\arctan"),
    of("sgn", 0, r"\operatorname{sgn}"),
    of("sign", 0, r"\operatorname{sgn}"),
];

/// Commands with an option in square brackets that changes nothing.
pub(super) const OPTIONS: &[&str] = &["color", "textcolor", "cancel", "bcancel", "xcancel", "smash"];

/// Commands whose scripts are remarks: `\underbrace{a+b}_{c}`.
pub(super) const REMARKED: &[&str] = &["underbrace", "overbrace", "underbracket", "overbracket"];

/// Units of siunitx, and what they print.
const UNITS: &[(&str, &str)] = &[
    ("metre", "m"),
    ("meter", "m"),
    ("m", "m"),
    ("second", "s"),
    ("s", "s"),
    ("kilogram", "kg"),
    ("kg", "kg"),
    ("gram", "g"),
    ("ampere", "A"),
    ("kelvin", "K"),
    ("K", "K"),
    ("mole", "mol"),
    ("candela", "cd"),
    ("newton", "N"),
    ("N", "N"),
    ("joule", "J"),
    ("J", "J"),
    ("watt", "W"),
    ("W", "W"),
    ("pascal", "Pa"),
    ("Pa", "Pa"),
    ("hertz", "Hz"),
    ("Hz", "Hz"),
    ("volt", "V"),
    ("V", "V"),
    ("ohm", r"\Omega"),
    ("coulomb", "C"),
    ("farad", "F"),
    ("henry", "H"),
    ("tesla", "T"),
    ("weber", "Wb"),
    ("radian", "rad"),
    ("litre", "l"),
    ("liter", "l"),
    ("hour", "h"),
    ("minute", "min"),
    ("electronvolt", "eV"),
    ("kilo", "k"),
    ("milli", "m"),
    ("centi", "c"),
    ("mega", "M"),
    ("giga", "G"),
    ("nano", "n"),
];

/// The macro of a name.
pub(super) fn find(name: &str) -> Option<&'static Macro> {
    MACROS.iter().find(|m| m.name == name)
}

/// The unit that a command of siunitx prints.
pub(super) fn unit(name: &str) -> Option<&'static str> {
    UNITS.iter().find(|(n, _)| *n == name).map(|(_, prints)| *prints)
}
