//! Letters and signs of Unicode, as LaTeX writes them.
//!
//! The names are those of the package unicode-math: φ (U+03C6) is `\varphi`, ϕ (U+03D5) is `\phi`.

/// Greek letters from α on, as commands without the backslash; an empty one is none that LaTeX has.
const GREEK: [&str; 25] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "",
    "pi",
    "rho",
    "varsigma",
    "sigma",
    "tau",
    "upsilon",
    "varphi",
    "chi",
    "psi",
    "omega",
];

/// Large Greek letters from Α on; those that look like Latin ones are none of LaTeX.
const LARGE_GREEK: [&str; 25] = [
    "", "", "Gamma", "Delta", "", "", "", "Theta", "", "", "Lambda", "", "", "Xi", "", "Pi", "", "", "Sigma", "",
    "Upsilon", "Phi", "", "Psi", "Omega",
];

/// Signs, one command or a few tokens each.
const SIGNS: &[(char, &str)] = &[
    ('−', "-"),
    ('–', "-"),
    ('·', r"\cdot"),
    ('⋅', r"\cdot"),
    ('∙', r"\cdot"),
    ('×', r"\times"),
    ('⨯', r"\times"),
    ('±', r"\pm"),
    ('∓', r"\mp"),
    ('∗', "*"),
    ('∕', "/"),
    ('⁄', "/"),
    ('≤', r"\le"),
    ('≥', r"\ge"),
    ('⩽', r"\le"),
    ('⩾', r"\ge"),
    ('≠', r"\ne"),
    ('≡', r"\equiv"),
    ('≔', r"\coloneqq"),
    ('∂', r"\partial"),
    ('∇', r"\nabla"),
    ('∆', r"\Delta"),
    ('□', r"\Box"),
    ('∞', r"\infty"),
    ('′', "'"),
    ('″', "''"),
    ('‴', "'''"),
    ('ℏ', r"\hbar"),
    ('ℓ', r"\ell"),
    ('ı', r"\imath"),
    ('ȷ', r"\jmath"),
    ('µ', r"\mu"),
    ('ϕ', r"\phi"),
    ('ϵ', r"\epsilon"),
    ('ϑ', r"\vartheta"),
    ('ϱ', r"\varrho"),
    ('ϖ', r"\varpi"),
    ('℘', r"\wp"),
    ('ℵ', r"\aleph"),
    ('ℜ', r"\Re"),
    ('ℑ', r"\Im"),
    ('†', r"\dagger"),
    ('⊤', r"\top"),
    ('→', r"\to"),
    ('⇒', r"\Rightarrow"),
    ('⇔', r"\Leftrightarrow"),
    ('…', r"\ldots"),
    ('⋯', r"\cdots"),
    ('∫', r"\int"),
    ('∬', r"\iint"),
    ('∮', r"\oint"),
    ('∑', r"\sum"),
    ('∏', r"\prod"),
    ('≈', r"\approx"),
    ('≃', r"\simeq"),
    ('∼', r"\sim"),
    ('∝', r"\propto"),
    ('≪', r"\ll"),
    ('≫', r"\gg"),
    ('∈', r"\in"),
    ('⟨', r"\langle"),
    ('⟩', r"\rangle"),
    ('‖', r"\Vert"),
    ('∥', r"\Vert"),
    ('∣', r"\vert"),
    ('⌊', r"\lfloor"),
    ('⌋', r"\rfloor"),
    ('⌈', r"\lceil"),
    ('⌉', r"\rceil"),
    ('°', r"^\circ"),
    ('½', r"\frac12"),
    ('⅓', r"\frac13"),
    ('⅔', r"\frac23"),
    ('¼', r"\frac14"),
    ('¾', r"\frac34"),
    ('⅕', r"\frac15"),
    ('⅙', r"\frac16"),
    ('⅛', r"\frac18"),
    ('ẋ', r"\dot{x}"),
    ('ẍ', r"\ddot{x}"),
    ('ẏ', r"\dot{y}"),
    ('ż', r"\dot{z}"),
    ('ṙ', r"\dot{r}"),
    ('ṗ', r"\dot{p}"),
    ('ṁ', r"\dot{m}"),
    ('ȧ', r"\dot{a}"),
    ('\u{a0}', "~"),
    ('\u{2009}', r"\,"),
    ('\u{202f}', r"\,"),
    ('\u{2005}', r"\:"),
    ('\u{200b}', " "),
    ('\u{2061}', " "),
    ('\u{2062}', " "),
    ('\u{feff}', " "),
];

/// Letters of the block of letterlike symbols, which the alphabets leave out: style and letter.
const LETTERLIKE: &[(char, &str, char)] = &[
    ('ℎ', "", 'h'),
    ('ℬ', "mathscr", 'B'),
    ('ℰ', "mathscr", 'E'),
    ('ℱ', "mathscr", 'F'),
    ('ℋ', "mathscr", 'H'),
    ('ℐ', "mathscr", 'I'),
    ('ℒ', "mathscr", 'L'),
    ('ℳ', "mathscr", 'M'),
    ('ℛ', "mathscr", 'R'),
    ('ℯ', "mathscr", 'e'),
    ('ℊ', "mathscr", 'g'),
    ('ℴ', "mathscr", 'o'),
    ('ℂ', "mathbb", 'C'),
    ('ℍ', "mathbb", 'H'),
    ('ℕ', "mathbb", 'N'),
    ('ℙ', "mathbb", 'P'),
    ('ℚ', "mathbb", 'Q'),
    ('ℝ', "mathbb", 'R'),
    ('ℤ', "mathbb", 'Z'),
];

/// Commands of style for the alphabets of 52 Latin letters from U+1D400 on.
const ALPHABETS: [&str; 13] = [
    "mathbf", "", "mathbf", "mathscr", "mathscr", "mathfrak", "mathbb", "mathfrak", "mathsf", "mathsf", "mathsf",
    "mathsf", "mathtt",
];

/// What a combining mark puts onto the letter before it.
pub(super) fn accent(mark: &str) -> Option<&'static str> {
    Some(match mark {
        "\u{307}" => "dot",
        "\u{308}" => "ddot",
        "\u{302}" => "hat",
        "\u{303}" => "tilde",
        "\u{304}" | "\u{305}" => "bar",
        "\u{20d7}" => "vec",
        _ => return None,
    })
}

/// What a small raised or lowered sign stands for: whether it is raised, and the sign.
pub fn script(sign: &str) -> Option<(bool, &'static str)> {
    const RAISED: [(&str, &str); 14] = [
        ("⁰", "0"),
        ("¹", "1"),
        ("²", "2"),
        ("³", "3"),
        ("⁴", "4"),
        ("⁵", "5"),
        ("⁶", "6"),
        ("⁷", "7"),
        ("⁸", "8"),
        ("⁹", "9"),
        ("⁻", "-"),
        ("⁺", "+"),
        ("ⁿ", "n"),
        ("ᵀ", "T"),
    ];
    const LOWERED: [(&str, &str); 13] = [
        ("₀", "0"),
        ("₁", "1"),
        ("₂", "2"),
        ("₃", "3"),
        ("₄", "4"),
        ("₅", "5"),
        ("₆", "6"),
        ("₇", "7"),
        ("₈", "8"),
        ("₉", "9"),
        ("ᵢ", "i"),
        ("ⱼ", "j"),
        ("ₙ", "n"),
    ];
    let find = |list: &'static [(&'static str, &'static str)]| list.iter().find(|(s, _)| *s == sign).map(|(_, to)| *to);
    find(&RAISED).map(|to| (true, to)).or_else(|| find(&LOWERED).map(|to| (false, to)))
}

/// A character as LaTeX writes it; `None` for one that has no meaning in a formula. Raised and lowered signs, and marks on letters, are
/// left as they are: what stands before them matters.
pub fn spelled(c: char) -> Option<String> {
    let styled =
        |style: &str, letter: &str| if style.is_empty() { letter.to_owned() } else { format!(r"\{style}{{{letter}}}") };
    if let Some((_, text)) = SIGNS.iter().find(|(sign, _)| *sign == c) {
        return Some((*text).to_owned());
    }
    if let Some((_, style, letter)) = LETTERLIKE.iter().find(|(sign, ..)| *sign == c) {
        return Some(styled(style, &letter.to_string()));
    }
    let mut one = [0; 4];
    let one: &str = c.encode_utf8(&mut one);
    if accent(one).is_some() || script(one).is_some() {
        return Some(one.to_owned());
    }
    let code = u32::from(c);
    let greek = |table: &[&str; 25], at: u32| match table.get(at as usize) {
        Some(&name) if !name.is_empty() => Some(format!(r"\{name}")),
        _ => None,
    };
    match code {
        0x391..=0x3a9 => greek(&LARGE_GREEK, code - 0x391),
        0x3b1..=0x3c9 => greek(&GREEK, code - 0x3b1),
        0x1d400..=0x1d6a3 => {
            let (alphabet, at) = ((code - 0x1d400) / 52, (code - 0x1d400) % 52);
            let letter = char::from_u32(if at < 26 { 0x41 + at } else { 0x61 + at - 26 })?;
            Some(styled(ALPHABETS.get(alphabet as usize)?, &letter.to_string()))
        }
        // Bold, italic, bold italic, sans-serif bold and bold italic Greek: 26 large letters with ∇, 25 small ones, and seven more.
        0x1d6a8..=0x1d7c9 => {
            let (alphabet, at) = ((code - 0x1d6a8) / 58, (code - 0x1d6a8) % 58);
            let name = match at {
                0..=24 => greek(&LARGE_GREEK, if at == 17 { 7 } else { at })?,
                25 => r"\nabla".to_owned(),
                26..=50 => greek(&GREEK, at - 26)?,
                51 => r"\partial".to_owned(),
                52 => r"\epsilon".to_owned(),
                53 => r"\vartheta".to_owned(),
                55 => r"\phi".to_owned(),
                56 => r"\varrho".to_owned(),
                57 => r"\varpi".to_owned(),
                _ => return None,
            };
            let bold = alphabet != 1 && name != r"\partial";
            Some(if bold { format!(r"\boldsymbol{{{name}}}") } else { name })
        }
        0x1d7ce..=0x1d7d7 => Some((code - 0x1d7ce).to_string()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::spelled;

    #[test]
    fn letters_of_unicode_are_those_of_latex() {
        for (c, text) in [
            ('α', r"\alpha"),
            ('ω', r"\omega"),
            ('φ', r"\varphi"),
            ('ϕ', r"\phi"),
            ('Ω', r"\Omega"),
            ('𝜃', r"\theta"),
            ('𝑥', "x"),
            ('𝐱', r"\mathbf{x}"),
            ('𝛀', r"\boldsymbol{\Omega}"),
            ('𝜕', r"\partial"),
            ('𝓛', r"\mathscr{L}"),
            ('ℒ', r"\mathscr{L}"),
            ('ℝ', r"\mathbb{R}"),
            ('−', "-"),
            ('½', r"\frac12"),
            ('²', "²"),
        ] {
            assert_eq!(spelled(c).as_deref(), Some(text), "{c}");
        }
        for c in ['é', 'Α', 'ο', '€', '中', '\u{7}'] {
            assert_eq!(spelled(c), None, "{c}");
        }
    }
}
