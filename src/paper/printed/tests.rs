use super::super::token::tokens;
use super::*;

fn read(environment: &str, text: &str) -> Vec<String> {
    read_spaced(environment, text)
        .iter()
        .map(|r| r.replace(" +", "+").replace(" -", "-").replace(" \\times", "\\times"))
        .collect()
}

fn read_spaced(environment: &str, text: &str) -> Vec<String> {
    let place = Place { environment, display: Some(0), section: 0, chapter: 0 };
    relations(&tokens(text), &place)
        .iter()
        .map(|r| {
            let remark = r.remark.as_ref().map(|w| format!(" [{w}]")).unwrap_or_default();
            let sides: Vec<&str> = r.sides.iter().map(|s| s.text.as_str()).collect();
            let mut out = sides[0].to_owned();
            for (sign, side) in r.signs.iter().zip(&sides[1..]) {
                out.push_str(&format!(" {sign} {side}"));
            }
            out + &remark
        })
        .collect()
}

#[test]
fn columns_are_relations_of_their_own() {
    assert_eq!(read("align", r"u &= ab & v &= cd"), ["u = ab", "v = cd"]);
    assert_eq!(read("align", r"u &= ab & v &= cd \\ &= ba & &= dc"), ["u = ab = ba", "v = cd = dc"]);
    assert_eq!(read("alignat", r"a &= b &+ c"), ["a = b+ c"]);
    assert_eq!(read("align", r"x &= y && \text{by (3)}"), ["x = y [by (3)]"]);
    assert_eq!(read("align", r"x &= y & \text{for } z&>0"), ["x = y [for]", "z > 0"]);
    assert_eq!(read("eqnarray", r"a &=& b \\ &=& c"), ["a = b = c"]);
}

#[test]
fn lines_go_on() {
    assert_eq!(read("align", r"E &= \frac12mv^2 \nonumber\\ &\quad+mgh"), [r"E = \frac12mv^2+mgh"]);
    assert_eq!(read("align", r"A &= (a+b)^2 \\ &= a^2+2ab+b^2"), ["A = (a+b)^2 = a^2+2ab+b^2"]);
    assert_eq!(read("multline", r"a = b \\ + c \\ - d"), ["a = b+ c- d"]);
    assert_eq!(read("align", r"a &= b \\ -c &= d"), ["a = b", "-c = d"]);
    assert_eq!(read("align", r"a &= \left(b \right. \\ & \left. c\right)"), [r"a = \left(b \right. \left. c\right)"]);
    assert_eq!(read("align", r"a &= x \\ &\quad \times y"), [r"a = x\times y"]);
    assert_eq!(read("equation", r"\begin{split} a &= b \\ &= c \end{split}"), ["a = b = c"]);
    assert_eq!(read("equation", r"\left\{\begin{aligned} a &= b \\ c &= d \end{aligned}\right."), ["a = b", "c = d"]);
    assert_eq!(read("equation", r"\begin{array}{rcl} a &=& b \\ &=& c \end{array}"), ["a = b = c"]);
    assert_eq!(read("gather", r"a = b \\ c = d"), ["a = b", "c = d"]);
}

/// A row with a sign and an equation of its own is one of its own where it begins where the row before does.
#[test]
fn rows_with_a_sign_and_an_equation() {
    let plain =
        |found: Vec<String>| found.iter().map(|r| r.replace([' '], "").replace("\\quad", "")).collect::<Vec<_>>();
    let own = |inner: &str, text: &str| plain(read("equation", &format!("\\begin{{{inner}}} {text} \\end{{{inner}}}")));
    assert_eq!(own("aligned", r"&a=b \\ &-a=-b"), ["a=b", "-a=-b"]);
    assert_eq!(own("aligned", r"F&=a \\ -g&=a"), ["F=a", "-g=a"]);
    assert_eq!(own("split", r"F=a \\ -g=a"), ["F=a", "-g=a"]);
    assert_eq!(own("gathered", r"F=a \\ -g=a"), ["F=a", "-g=a"]);
    assert_eq!(own("split", r"y=&a \\ &-c=d"), ["y=a-c=d"]);
    assert_eq!(own("split", r"&y=a \\ &\quad-c=d"), ["y=a-c=d"]);
    assert_eq!(plain(read("multline", r"a = b \\ -c = d")), ["a=b-c=d"]);
}

/// A name in upright letters before its argument is no word between formulas.
#[test]
fn names_in_text_are_parts_of_a_formula() {
    for command in ["text", "textrm", "mbox", "textbf", "textit"] {
        for name in ["Alt", "Tr", "det", "erf", "Hom"] {
            for argument in ["(x)", r"\left(x\right)", "[x]", "x", " x", r"\rho"] {
                let formula = format!(r"a=b\{command}{{{name}}}{argument}+c");
                assert_eq!(read("[", &formula).len(), 1, "{formula}");
            }
        }
    }
    assert_eq!(read("[", r"f=\int x\,\text{d}x=y").len(), 1);
    assert_eq!(read("[", r"x^2 \text{ mod } 7=3").len(), 1);
    // Words are.
    assert_eq!(read("[", r"a=b \text{ if } (c>0)").len(), 2);
    assert_eq!(read("[", r"a=b \text{for}\quad c>0").len(), 2);
    assert_eq!(read("[", r"a=b \qq{using} c=d"), ["a = b [using]", "c = d"]);
    assert_eq!(read("[", r"a=b \qq*{using} c=d"), ["a = b [using]", "c = d"]);
}

#[test]
fn what_is_between_brackets_is_not_cut() {
    assert_eq!(read("[", r"\Phi=\left\{T, V, n\right\}"), [r"\Phi = \left\{T, V, n\right\}"]);
    assert_eq!(read("[", r"\Phi=\{T, V, n\}"), [r"\Phi = \{T, V, n\}"]);
    assert_eq!(read("[", r"f(x,y)=1, \quad g=2."), ["f(x,y) = 1", "g = 2"]);
    assert_eq!(read("[", r"A=\begin{pmatrix}1&2\\3&4\end{pmatrix}."), [r"A = \begin{pmatrix}1&2\\3&4\end{pmatrix}"]);
    assert_eq!(read("[", r"x=1.5, y=2"), ["x = 1.5", "y = 2"]);
}

#[test]
fn nothing_is_dropped() {
    assert_eq!(read("[", r"i=1,2,3"), ["i = 1,2,3"]);
    assert_eq!(read("[", r"a=b \text{ and } c=\text{const}"), ["a = b [and]", r"c = \text{const}"]);
    // Parentheses around a remark are no part of it.
    assert_eq!(read("[", r"a=b \quad (x>0)"), ["a = b", "x > 0"]);
    assert_eq!(read("align", r"a &= b \\ \intertext{and so} c &= d"), ["a = b [and so]", "c = d"]);
    assert_eq!(read("[", r"a=b \Rightarrow c=d"), ["a = b", "c = d [⇒]"]);
    assert_eq!(read("[", r"a \stackrel{!}{=} b"), [r"a \stackrel{!}{=} b [!]"]);
    assert_eq!(read("[", r"x \not= y"), [r"x \not= y"]);
    assert_eq!(read("[", r"x := y"), [r"x := y"]);
}

#[test]
fn every_mark_that_prints_is_somewhere() {
    let letters = |text: &str| {
        let text = text.replace(r"\Rightarrow", "");
        let mut found: Vec<char> = text.chars().filter(|c| c.is_ascii_uppercase()).collect();
        found.sort_unstable();
        found
    };
    for (environment, text) in [
        ("align", r"A &= B & C &= D \\ &\quad + E & &= F, \quad G \\ H && \text{I} & J"),
        ("equation", r"\left\{\begin{aligned} A &= B, C \\ D \end{aligned}\right. \qquad E \text{F} G"),
        ("gather", r"A \\ B = \\ C \\ + D \intertext{E} \Rightarrow F"),
        ("eqnarray", r"A &=& B \\ C & & D \\ & & E & F"),
        ("multline", r"A = B, \\ C \\ \text{D} = E"),
    ] {
        assert_eq!(letters(&read(environment, text).join(" ")), letters(text), "{text}");
    }
}

#[test]
fn no_text_panics() {
    let text = r"\left\{\begin{aligned}a&=\left(b\right.\\&+c,\quad\stackrel{a}{=}\text{x}\not\end{aligned}\right.\Rightarrow\begin{array}{l}a&=&b\end{array}:=\intertext{a}";
    for environment in ["align", "equation", "multline", "eqnarray", ""] {
        for end in 0..text.len() {
            read(environment, &text[..end]);
        }
    }
}
