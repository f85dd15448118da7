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

/// Formulas without the spaces that they are set with.
fn close(environment: &str, text: &str) -> Vec<String> {
    read(environment, text).iter().map(|r| r.replace(' ', "").replace(r"\quad", "").replace("{}", "")).collect()
}

/// A relation goes on from what stands before it in its row, or else from the row above in its column; equations side by side are no chain.
#[test]
fn equations_side_by_side_are_no_chain() {
    // Cells of an `eqnarray` are set apart, whatever stands in them.
    assert_eq!(close("eqnarray", r"a=b & c=d & e=f"), ["a=b", "c=d", "e=f"]);
    assert_eq!(close("eqnarray*", r"a=b & c=d \\ =g & =h"), ["a=b=g", "c=d=h"]);
    assert_eq!(close("eqnarray", r"a=b && c=d"), ["a=b", "c=d"]);
    assert_eq!(close("eqnarray", r"a&=&b \\ c=d && e=f"), ["a=b", "c=d", "e=f"]);
    assert_eq!(close("eqnarray", r"a&=&b & c&=&d \\ &=&e & &=&f"), ["a=b=e", "c=d=f"]);
    // The columns that are printed, not those of the environment.
    for environment in ["align", "eqnarray", "aligned"] {
        assert_eq!(close(environment, r"a&=&b & c&=&d"), ["a=b", "c=d"], "{environment}");
        assert_eq!(close(environment, r"a&=&b & c&=&d \\ &=&e & &=&f"), ["a=b=e", "c=d=f"], "{environment}");
        assert_eq!(close(environment, r"a&=&b \\ &&+c"), ["a=b+c"], "{environment}");
        assert_eq!(close(environment, r"a&{}={}&b \\ c&{}={}&d"), ["a=b", "c=d"], "{environment}");
    }
    // A column that goes on beside one that does not.
    assert_eq!(close("align", r"u&=ab & v&=cd \\ &+e & -w&=f"), ["u=ab+e", "v=cd", "-w=f"]);
    assert_eq!(close("align", r"u&=ab & v&=cd \\ &+e & &=dc"), ["u=ab+e", "v=cd=dc"]);
    assert_eq!(close("align", r"u&=ab & v&=cd \\ w&=xy & &=dc"), ["u=ab", "v=cd=dc", "w=xy"]);
    assert_eq!(close("align", r"a&=b & &=c \\ d&=e & &=f"), ["a=b=c", "d=e=f"]);
    assert_eq!(close("align", r"a&=b & -c&=d"), ["a=b", "-c=d"]);
    assert_eq!(close("align", r"(1)& & -x&=2"), ["(1)", "-x=2"]);
}

/// Terms in columns of their own, as systems of equations are set, are one side.
#[test]
fn terms_in_columns_are_one_side() {
    for environment in ["align", "alignat", "alignedat"] {
        assert_eq!(close(environment, r"x&+y&=2 \\ 2x&-y&=1"), ["x+y=2", "2x-y=1"], "{environment}");
        assert_eq!(close(environment, r"x&+y&-z&=2 \\ &+y&-z&=1"), ["x+y-z=2", "+y-z=1"], "{environment}");
        assert_eq!(close(environment, r"x&{}+{}&y&{}={}&2 \\ x&{}-{}&y&{}={}&0"), ["x+y=2", "x-y=0"], "{environment}");
        assert_eq!(close(environment, r"x&+y& &=2 \\ x&-y& &=0"), ["x+y=2", "x-y=0"], "{environment}");
    }
    // In columns without a space between them, a sign goes on.
    assert_eq!(close("alignat", r"a&=b &+c&=d"), ["a=b+c=d"]);
    assert_eq!(close("alignat", r"a&=b &\qquad -c&=d"), ["a=b", "-c=d"]);
}

/// Words, and wide spaces before a sign, part two formulas.
#[test]
fn formulas_beside_each_other_are_no_sum() {
    assert_eq!(close("[", r"a=b \qquad -c=d").len(), 2);
    assert_eq!(close("[", r"a=b \text{ and } -c=d"), ["a=b[and]", "-c=d"]);
    assert_eq!(close("[", r"a=b \text{ and } c=d"), ["a=b[and]", "c=d"]);
    assert_eq!(close("gather", r"a=b \\ \text{or}\quad -c=d"), ["a=b[or]", "-c=d"]);
    assert_eq!(close("[", r"a=b \quad =c"), ["a=b=c"]);
    assert_eq!(close("[", r"a=b \quad +c"), ["a=b+c"]);
    // Neither value is what the name is equal to.
    for text in [
        r"x=1 \text{ or } -1",
        r"x=1 \text{ or } 2",
        r"x=1 \quad\text{and}\quad 2",
        r"x=1 \text{ or } x=2 \text{ or } 3",
        r"x=1, 2",
    ] {
        let place = Place { environment: "[", display: Some(0), section: 0, chapter: 0 };
        let found = relations(&tokens(text), &place);
        assert!(found.last().is_some_and(|r| r.sides.last().is_some_and(|s| s.is_list)), "{text}: {found:?}");
    }
    // Of two names before one sign neither is said what it is equal to; an order, or an equation behind a wide space, is one of the last.
    let first = |text: &str| {
        let place = Place { environment: "[", display: Some(0), section: 0, chapter: 0 };
        let found = relations(&tokens(text), &place);
        (found.len(), found[0].sides[0].is_list)
    };
    for text in [r"r_1, r_2=-p\pm q", "x,y=0", "x,y,z=0", r"f(x), g(x) \approx x^2", r"r_1, r_2=-p\pm\sum_{i<3}q_i"] {
        assert_eq!(first(text), (1, true), "{text}");
    }
    for text in ["x,y>0", r"x,\quad y=0", "u=1, v=2", r"x, \sum_{i=1}^n y_i>0"] {
        assert_eq!(first(text), (2, false), "{text}");
    }
    // Two equations that are set without a space between them are read as neither.
    let place = Place { environment: "align", display: Some(0), section: 0, chapter: 0 };
    assert!(relations(&tokens("a=b & c=d"), &place).iter().flat_map(|r| &r.sides).all(|s| s.is_list));
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
    let lines = r"A=\begin{bmatrix} 1 \\ \noalign{\smallskip} 2 \end{bmatrix}";
    assert_eq!(read("[", lines), [r"A = \begin{bmatrix} 1 \\ 2 \end{bmatrix}"]);
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
        ("equation", r"\begin{array}{c} A = B \\ C = D \end{array}"),
        ("equation", r"\begin{array}{c} A \\ C = D \end{array}"),
        ("equation", r"\begin{array}{ll} A = B & C = D \\ E = F \end{array}"),
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

/// A number, or one of the first letters, in parentheses behind a space is that of a line; a name is an argument.
#[test]
fn a_number_by_hand_is_no_factor() {
    for number in ["(2)", "(12a)", "(a)", "(3')"] {
        assert_eq!(close("[", &format!(r"F=ma\ {number}")), ["F=ma"], "{number}");
    }
    for factor in ["(x)", "(m)", "(e)", "(2x)", "(a+b)"] {
        assert_eq!(close("[", &format!(r"F=m\ {factor}")), [format!(r"F=m{factor}")], "{factor}");
    }
    assert_eq!(close("[", r"F=m(2)"), ["F=m(2)"]);
}

#[test]
fn an_option_of_rows_prints_nothing() {
    assert_eq!(close("[", r"\begin{aligned}[t] a&=b \\ c&=d \end{aligned}"), ["a=b", "c=d"]);
    assert_eq!(close("[", r"\begin{aligned} [b] a&=b \end{aligned}"), ["a=b"]);
    assert_eq!(close("[", r"\begin{aligned} [a]&=b \end{aligned}").len(), 1);
}
