use super::super::token::tokens;
use super::*;

fn expanded(text: &str) -> Result<Vec<Token>, Endless> {
    super::expanded(tokens(text), Vec::new(), &BTreeSet::new(), Definitions::OfTheirGroup, &mut |_, _, _| Vec::new())
        .map(|e| e.tokens)
}

fn shown(text: &str) -> String {
    let all = expanded(text).unwrap_or_else(|e| panic!("{e:?}"));
    let one = |t: &Token| if t.kind == Kind::Command { format!("\\{} ", t.text) } else { t.text.to_string() };
    all.iter().map(one).collect::<String>().trim().to_owned()
}

#[test]
fn macros_are_expanded_as_latex_does() {
    assert_eq!(shown(r"\newcommand{\w}{\boldsymbol\Omega}\w x"), r"\boldsymbol \Omega x");
    assert_eq!(shown(r"\newcommand\d[2][t]{\frac{d#2}{d#1}}\d x\d[s]{y}"), r"\frac {dx}{dt}\frac {dy}{ds}");
    assert_eq!(shown(r"\def\a#1{<#1>}\def\b{\a}\b{x}"), "<x>");
    assert_eq!(shown(r"\DeclareMathOperator{\tr}{tr}\tr A"), r"\operatorname {tr}A");
    assert_eq!(shown(r"\let\eps=\epsilon\eps"), r"\epsilon");
    assert_eq!(shown(r"\providecommand{\x}{1}\renewcommand*{\x}{2}\providecommand{\x}{3}\x"), "2");
    assert_eq!(shown(r"\newcommand{\x}{1}\iffalse\newcommand{\x}{2}\ifx a\fi\fi\x"), "1");
    assert_eq!(shown(r"a\end{document}b"), "a");
    // A name that is let is what it was.
    assert_eq!(shown(r"\let\s\section\renewcommand\section[1]{(\s{#1})}\section{a}"), r"(\section {a})");
    assert_eq!(shown(r"\let\nc\newcommand\nc{\x}{1}\x"), "1");
    assert_eq!(
        shown(r"\newenvironment{e}{\begin{equation}}{\end{equation}}\begin{e}x\end{e}"),
        r"\begin {equation}x\end {equation}"
    );
    assert_eq!(shown(r"\NewDocumentCommand{\v}{m}{\vec{#1}}\v{x}"), r"\vec {x}");
    assert_eq!(shown(r"\NewDocumentCommand{\v}{O{2} m}{#2^{#1}}\v{x}\v[3]y"), "x^{2}y^{3}");
    assert_eq!(shown(r"\NewDocumentCommand{\r}{mmO{l}}{#2_#3}\r{x}{y}\r{x}{z}[c]"), "y_lz_c");
    // Arguments with signs between them, as TeX takes them.
    assert_eq!(shown(r"\def\at(#1,#2)#3{#3_#1^#2}\at(a,{(b)})x \at (c,{d,e})y"), "x_a^(b) y_c^d,e");
    assert_eq!(shown(r"\def\to#1\by#2.{#1/#2}\to{a}b\by c.d"), "{a}b/cd");
    assert_eq!(shown(r"\DeclarePairedDelimiter\n{\lVert}{\rVert}\n{x}\n*{y}\n[\big]z").matches("left").count(), 3);
}

#[test]
fn definitions_end_with_what_they_stand_in() {
    let a = r"\def\A{a}";
    for (scope, after) in [
        (r"{\def\A{b}}", "a"),
        (r"{\newif\ifA{\def\A{b}}\renewcommand{\A}{c}}", "a"),
        (r"\begingroup\renewcommand\A{b}\endgroup", "a"),
        (r"\bgroup\let\A=b\egroup", "a"),
        (r"$\def\A{b}$", "a"),
        (r"$$\def\A{b}$$", "a"),
        (r"\[\DeclareMathOperator{\A}{b}\]", "a"),
        (r"\(\def\A{b}\)", "a"),
        (r"\left(\def\A{b}\right)", "a"),
        (r"\begin{center}\def\A{b}\end{center}", "a"),
        (r"\newenvironment{e}{\def\A{b}}{}\begin{e}\end{e}", "a"),
        (r"\let\bg\begingroup\let\eg\endgroup\bg\def\A{b}\eg", "a"),
        (r"\let\b\begin\let\e\end\b{center}\def\A{b}\e{center}", "a"),
        (r"\begin{align}\def\A{b}&\end{align}", "a"),
        (r"\begin{align}\def\A{b}\\", "a"),
        (r"\begin{array}{c}x&\def\A{b}&", "a"),
        (r"\begin{pmatrix}\def\A{b}&", "a"),
        (r"\textbf{\def\A{b}}", "a"),
        // A brace that is not closed ends with its environment.
        (r"\begin{center}{\def\A{b}\end{center}", "a"),
        // What is global, or in no group of its own, goes on.
        (r"{\gdef\A{b}}", "b"),
        (r"{\def\A{c}{\global\def\A{b}}\def\A{d}}", "b"),
        (r"{\global\long\def\A{b}}", "b"),
        (r"{\global\let\A=b}", "b"),
        (r"\def\B{\def\A{b}}\B", "b"),
        (r"\AtBeginDocument{\def\A{b}}", "b"),
        (r"\begin{document}\def\A{b}", "b"),
        (r"}\endgroup\end{x}\]\def\A{b}", "b"),
    ] {
        let found = shown(&format!("{a}{scope}\\A"));
        assert!(found.ends_with(after), "{scope}: {found}");
    }
    // In the group it is what it says; the condition of a group, too.
    assert_eq!(shown(&format!(r"{a}{{\def\A{{b}}\A}}\A")), "{b}a");
    assert_eq!(shown(r"\newif\ifd{\dtrue\ifd a\fi}\ifd b\else c\fi"), "{a}c");
    // On a page all formulas have the definitions of each.
    let of_page = super::expanded(
        tokens(r"$\def\A{b}$\A"),
        Vec::new(),
        &BTreeSet::new(),
        Definitions::OfTheWhole,
        &mut |_, _, _| Vec::new(),
    );
    assert!(of_page.expect("ends").tokens.last().is_some_and(|t| t.text == "b"));
}

#[test]
fn edef_takes_what_is_meant_now() {
    assert_eq!(shown(r"\def\A{x}\edef\B{\A}\def\A{y}\B\A"), "xy");
    assert_eq!(shown(r"\def\A#1{<#1>}{\xdef\B#1{\A{#1}}}\def\A#1{}\B z"), "{}<z>");
    assert_eq!(shown(r"\def\A{x}\def\B{\A}\def\A{y}\B"), "y");
    assert_eq!(shown(r"\DeclareRobustCommand\A{x}\edef\B{\A}\DeclareRobustCommand\A{y}\B"), "y");
    assert!(expanded(r"\def\A{\A\A}\edef\B{\A}").is_ok());
}

#[test]
fn commands_of_latex_are_provided() {
    assert_eq!(shown(r"\providecommand{\pi}{3}\pi\providecommand{\ppi}{4}\ppi"), r"\pi 4");
    assert_eq!(shown(r"\let\p\psi\providecommand{\p}{3}\p"), r"\psi");
}

#[test]
fn an_argument_of_a_macro_of_latex_is_all_that_is_printed() {
    let xx = r"\def\xx{x+y}";
    for (call, printed) in [
        (r"\frac1\xx", r"\frac 1{x+y}"),
        (r"\frac\xx\xx z", r"\frac {x+y}{x+y}z"),
        (r"\frac{1}\xx\xx", r"\frac {1}{x+y}x+y"),
        (r"\frac{\frac1\xx}\xx", r"\frac {\frac 1{x+y}}{x+y}"),
        (r"\binom\xx2\dfrac2\xx", r"\binom {x+y}2\dfrac 2{x+y}"),
        (r"\def\h#1{\frac#12}\h\xx", r"\frac {x+y}2"),
        (r"\def\y{\xx}\frac1\y", r"\frac 1{x+y}"),
        (r"\mathbf\xx", r"\mathbf {x+y}"),
        // TeX expands what stands behind these before it takes the first of it.
        (r"\sqrt\xx", r"\sqrt x+y"),
        (r"a^\xx_\xx", r"a^x+y_x+y"),
        (r"\frac{\xx}2\xx", r"\frac {x+y}2x+y"),
    ] {
        assert_eq!(shown(&format!("{xx}{call}")), printed, "{call}");
    }
}

/// What is printed without a doubt, and what is in doubt.
fn with_doubts(text: &str) -> (String, String) {
    let all = super::expanded(tokens(text), Vec::new(), &BTreeSet::new(), Definitions::OfTheirGroup, &mut |_, _, _| {
        Vec::new()
    });
    let all = all.unwrap_or_else(|e| panic!("{e:?}"));
    let (mut sure, mut unsure) = (String::new(), String::new());
    for token in all.tokens.iter().filter(|t| t.kind == Kind::Other) {
        let to = if all.doubts.of(&token.span).is_some() { &mut unsure } else { &mut sure };
        to.push_str(&token.text);
    }
    (sure, unsure)
}

#[test]
fn branches_that_are_not_known_are_in_doubt() {
    for (text, sure, unsure) in [
        (r"a\iffalse b\else c\fi d", "acd", ""),
        (r"a\iftrue b\else c\fi d", "abd", ""),
        (r"\newif\ifd\dtrue\ifd a\ifnum0=1 b\else c\fi d\else e\fi f", "adf", "0=1bc"),
        (r"\newif\ifd\ifd a\ifx xy b\else c\fi d\else e\fi f", "ef", ""),
        (r"\newif\ifd\unless\ifd a\else b\fi c", "ac", ""),
        (r"\newif\ifd\dtrue\unless\ifd a\else b\fi c", "bc", ""),
        (r"\let\ifd\iftrue\ifd a\else b\fi c", "ac", ""),
        (r"\ifnum0=1 \newif\ifd\dtrue\fi\ifd a\else b\fi c", "c", "0=1ab"),
        (r"\newif\ifd\ifnum0=1 \dtrue\fi\ifd a\else b\fi c", "c", "0=1ab"),
        (r"\ifcase1 a\or b\else c\fi d", "d", "1abc"),
        (r"\ifx\a\b a\iftrue b\else c\fi d\fi e", "e", "abd"),
        (r"\ifdefined\undefined a\else b\fi c", "c", "ab"),
        (r"\def\A{a}\ifdefined\A b\else c\fi d", "bd", ""),
        (r"\iftoggle{x}{a}{b}c", "c", "ab"),
        (r"\ifthenelse{\equal{x}{y}}{a}{b}c", "c", "ab"),
        (r"\makeatletter\@ifundefined{x}{a}{b}c", "c", "ab"),
        // Of a command that is not known, what follows says how it goes on.
        (r"\ifmine a\else b\fi c", "c", "ab"),
        (r"\ifmine{x}{a}{b}c", "c", "xab"),
        (r"\ifmine{a}\else b\fi c", "c", "ab"),
        (r"\IfStrEq{x}{y}{a}{b}c", "c", "xyab"),
        (r"\makeatletter\@ifstar{a}{b}c", "c", "ab"),
        (r"\makeatletter\@firstoftwo{a}{b}\@secondoftwo{c}{d}\@gobble{e}", "ad", ""),
        (r"\iffalse \ifthenelse{x}{a}{b}\fi c", "c", ""),
        (r"a\iff b\ifoo c", "abc", ""),
        // Names that are defined in a branch.
        (r"\def\A{a}\ifnum0=1 \def\A{b}\fi\A c", "c", "0=1b"),
        (r"\def\A{a}\ifnum0=1 \def\A{a}\fi\A c", "ac", "0=1"),
        (r"\def\A{a}{\ifnum0=1 \def\A{b}\fi}\A c", "ac", "0=1"),
        (r"\ifnum0=1 \def\A{b}\fi\def\A{a}\A c", "ac", "0=1"),
        (r"\ifnum0=1 \def\A{b}\fi\def\B{<\A>}\B\let\C\A\C c", "c", "0=1<b>b"),
        (r"\iftoggle{x}{\def\A{a}}{\def\A{b}}\A c", "c", "b"),
        (r"\def\A{a}\edef\B{\noexpand\A}\B c", "c", "a"),
        (r"\ifnum0=1 \let\s\sin\else\let\s\cos\fi\s{x}c", "c", "0=1x"),
        (r"\ifnum0=1 \let\my\iftrue\else\let\my\iffalse\fi\my a\else b\fi c", "c", "0=1ab"),
        // What such a name makes of its arguments.
        (r"\ifnum0=1 \def\H#1{}\else\def\H#1{#1}\fi\H{a{b}} c\H[x]{y}", "c", "0=1ab[x]y"),
        (r"\ifnum0=1 \def\H#1.{#1}\fi\H ab. c", "c", "0=1ab"),
        // Environments.
        (
            r"\ifnum0=1 \newenvironment{e}{\comment}{\endcomment}\else\newenvironment{e}{}{}\fi a\begin{e}b\end{e}c",
            "ac",
            "0=1b",
        ),
        (r"\NewDocumentEnvironment{e}{d()}{}{}a\begin{e}b\end{e}c", "ac", "b"),
        // What may end here.
        (r"a\ifnum0=1 \endinput\fi b", "a", "0=1b"),
        (r"a\ifnum0=1 \end{document}\fi b\end{document}c", "a", "0=1documentb"),
    ] {
        assert_eq!(with_doubts(text), (sure.to_owned(), unsure.to_owned()), "{text}");
    }
}

#[test]
fn a_definition_that_is_not_understood_puts_its_name_in_doubt() {
    for define in [
        r"\appto\A{x}",
        r"\gappto\A{x}",
        r"\patchcmd{\A}{a}{b}{}{}",
        r"\pretocmd\A{x}{}{}",
        r"\RenewDocumentCommand{\A}{d() m}{x}",
        r"\NewDocumentCommand\A{r()}{x}",
        r"\GlobalLetLtxMacro\A\B",
        r"\csappto{A}{x}",
        r"\csundef{A}",
        r"\undef\A",
        r"\makeatletter\g@addto@macro\A{x}",
        r"\makeatletter\g@addto@macro{\A}{x}",
        r"\mathchardef\A=1",
        r"\chardef\A 65 ",
        r"\newcount\A",
        r"\futurelet\A\B\C",
        r"\FPset\A{3}",
        r"\FPeval{\A}{3}",
        r"\pgfmathsetmacro{\A}{3}",
        r"\pgfmathsetmacro\A{3}",
        r"\DeclarePairedDelimiterX\A[1]{(}{)}{#1}",
        r"\robustify{\A}",
        r"\mydefinition{\A}{x}",
        r"{\appto\A{x}}",
        // Whether that is done, and when.
        r"\DeclareOption{x}{\def\A{b}}",
        r"\unknown[x]{\def\A{b}}",
        r"\unknown*{y}{\def\A{b}}",
        r"\AtEndDocument{\def\A{b}}",
        r"\edef\A{\the\B}",
    ] {
        let (sure, unsure) = with_doubts(&format!(r"\def\A{{Q}}{define}$\A$"));
        assert!(!sure.contains('Q') && (unsure.contains('Q') || !define.contains("app")), "{define}: {sure}, {unsure}");
    }
    // These change nothing.
    for other in [
        r"\textbf{\A}",
        r"\section{\A}",
        r"\noindent\A",
        r"$\unknown{\A}$",
        r"$\defeq\A$",
        r"\emph{\def\A{b}}",
        r"\unknown{x}{\def\A{b}}\def\A{a}",
    ] {
        let (sure, _) = with_doubts(&format!(r"\def\A{{a}}{other}$\A c$"));
        assert!(sure.ends_with("ac"), "{other}: {sure}");
    }
    // So with what LaTeX has: `\sin` is in doubt, not read as a sine.
    let doubts = |text: &str| {
        let all =
            super::expanded(tokens(text), Vec::new(), &BTreeSet::new(), Definitions::OfTheirGroup, &mut |_, _, _| {
                Vec::new()
            });
        let all = all.expect("ends");
        let sine = all.tokens.iter().rfind(|t| t.is("sin")).expect("is printed");
        all.doubts.of(&sine.span).map(|(_, doubt)| doubt.why())
    };
    assert_eq!(doubts(r"\appto\sin{x}$\sin$"), Some(r"what \sin stands for is not known".to_owned()));
    assert_eq!(
        doubts(r"\RenewDocumentCommand{\sin}{d() m}{x}$\sin$"),
        Some(r"what \sin stands for is not known".to_owned())
    );
    assert_eq!(doubts(r"\appto\cos{x}$\sin$"), None);
    // How far an accent reaches, packages decide.
    let (sure, unsure) = with_doubts(r"\def\A{a}\def\B{b+c}\hat\A\hat{\B}d\hat\B");
    assert_eq!((sure.as_str(), unsure.as_str()), ("ab+cd", "b+c"));
}

#[test]
fn names_are_put_together_as_tex_does() {
    for (text, printed) in [
        (r"\expandafter\def\csname A\endcsname{b}\A", "b"),
        (r"\def\n{A}\expandafter\newcommand\csname\n\endcsname{b}\A", "b"),
        (r"\def\mk#1{\expandafter\def\csname v#1\endcsname{\mathbf{#1}}}\mk{a}\va", r"\mathbf {a}"),
        (r"\makeatletter\@namedef{A}{b}\A\csname A\endcsname", r"\makeatletter bb"),
        (r"\csdef{A}#1{<#1>}\A c", "<c>"),
        (r"{\csgdef{A}{b}}\A", "{}b"),
        (r"\def\B{b}\letcs\A{B}\A\cslet{C}\B\C\csletcs{D}{B}\D", "bbb"),
        (r"\def\B{b}\NewCommandCopy{\A}{\B}\def\B{c}\A", "b"),
        (r"\newrobustcmd{\A}[1]{<#1>}\renewrobustcmd\A[1]{>#1<}\A b", ">b<"),
        (r"\def\A#1{<#1>}\def\b{cd}\expandafter\A\b", "<c>d"),
        (r"\def\A#1#2{<#2#1>}\def\b{cd}\expandafter\A\expandafter x\b", "<cx>d"),
        (r"\newif\ifd\csname dtrue\endcsname\ifd a\else b\fi", "a"),
        (r"\newif\ifd\booltrue{d}\ifd a\else b\fi\boolfalse{d}\ifd a\else b\fi", "ab"),
        (r"\newbool{d}\setbool{d}{true}\ifd a\else b\fi", "a"),
        (r"\expandafter\let\csname A\expandafter\endcsname\csname B\endcsname\def\B{c}\A", r"\B"),
        (r"\def\B{b}\expandafter\let\csname A\expandafter\endcsname\csname B\endcsname\def\B{c}\A", "b"),
        (r"\def\n{A}\expandafter\def\csname\expandafter\n\endcsname{b}\A", "b"),
        (r"{\global\expandafter\def\csname A\endcsname{b}}\A", "{}b"),
        (r"{\global\relax\def\A{b}}\A", "{}b"),
        (r"\NewDocumentCommand{\A}{s m}{<#2>}\A{b}\A*{c}", "<b><c>"),
        (r"\NewDocumentCommand{\A}{+m !o}{<#1>}\A{b}\A{c}[d]", "<b><c>"),
        (r"\let\bcom\iffalse\let\ecom\fi a\bcom b\ecom c", "ac"),
        (r"\AtEndPreamble{\def\A{b}}\def\A{c}\begin{document}\A", r"\begin {document}b"),
        // What waits for the beginning of the document.
        (r"\AtBeginDocument{\def\A{b}}\def\A{c}\begin{document}\A", r"\begin {document}b"),
        (r"\newif\ifd\AtBeginDocument{\dtrue}\dfalse\begin{document}\ifd a\else b\fi", r"\begin {document}a"),
        (r"\sqrt[3]\A", r"\sqrt [3]\A"),
        (r"\def\A{a+b}\sqrt[3]\A\sqrt\A", r"\sqrt [3]{a+b}\sqrt a+b"),
    ] {
        assert_eq!(shown(text), printed, "{text}");
    }
    assert!(expanded(r"\def\a{\expandafter\a\a}\a").is_err());
    for text in [r"\expandafter", r"\csname ", r"\expandafter\csname "] {
        let _ = expanded(&text.repeat(100_000));
    }
}

#[test]
fn environments_are_two_commands() {
    for (text, printed) in [
        (r"\newenvironment{e}{\align}{\endalign}\begin{e}x\end{e}", r"\begin {align}x\end {align}"),
        (r"\def\e{\begin{equation}}\def\ende{\end{equation}}\begin{e}x\end{e}", r"\begin {equation}x\end {equation}"),
        (r"\let\e\equation\let\ende\endequation\begin{e}x\end{e}", r"\begin {equation}x\end {equation}"),
        (r"\newenvironment{e}{[}{]}\e x\ende", "[x]"),
        (
            r"\newenvironment{e}{\begin {equation}}{\end {equation}}\begin {e}x\end {e}",
            r"\begin {equation}x\end {equation}",
        ),
        (r"\newenvironment{equation}{(}{)}\begin{equation}x\end{equation}", "(x)"),
        (r"\NewDocumentEnvironment{e}{m}{<#1}{>}\begin{e}{a}x\end{e}", "<ax>"),
        // The copy of a display, and what is put before one.
        (
            r"\expandafter\let\csname o\expandafter\endcsname\csname equation\endcsname\renewenvironment{equation}{!\o}{\endequation}\begin{equation}x",
            r"!\begin {equation}x",
        ),
        (r"\cspreto{equation}{}\begin{equation}x\end{equation}", r"\cspreto {}\begin {equation}x\end {equation}"),
        (r"\let\o\equation\def\equation{\o}\begin{equation}x\end{equation}", r"\begin {equation}x\end {equation}"),
        (
            r"\GlobalLetLtxMacro\equation\x\begin{equation}x\end{equation}",
            r"\GlobalLetLtxMacro \x \begin {equation}x\end {equation}",
        ),
        (r"\NewDocumentEnvironment{e}{m +b}{<#1|#2>}{!}\begin{e}{a}x\end{e}", "<a|x>!"),
    ] {
        assert_eq!(shown(text), printed, "{text}");
    }
}

#[test]
fn what_is_not_given_stands_at_the_call() {
    let text = r"\newcommand{\a}[1][xy]{#1}\NewDocumentCommand{\b}{mO{z}}{#2}\a \b{}";
    let all = expanded(text).expect("ends");
    assert!(all.iter().filter(|t| "xyz".contains(t.text.as_str())).all(|t| t.span.start > text.len() - 8));
}

#[test]
fn what_nothing_closes_is_told() {
    let all = super::expanded(
        tokens(r"a\iffalse b"),
        Vec::new(),
        &BTreeSet::new(),
        Definitions::OfTheirGroup,
        &mut |_, _, _| Vec::new(),
    );
    assert_eq!(all.expect("ends").notes.len(), 1);
}

#[test]
fn many_conditions_take_no_long_time() {
    for text in [r"\ifx ", r"\iftrue ", r"\ifmine ", r"\ifmine{", r"\begingroup}", r"\iftoggle{", r"{\def\a{"] {
        let _ = expanded(&text.repeat(100_000));
    }
}

#[test]
fn what_prints_its_argument_is_that() {
    assert_eq!(shown(r"x=\answer[given]{a+b}"), "x={a+b}");
    assert_eq!(shown(r"x=\answer{a+b} y"), "x={a+b} y");
    assert_eq!(shown(r"\answer [tolerance=.1] {2}"), " {2}".trim());
    // Without braces it is another one, and the paper's own is what it says.
    assert_eq!(shown(r"\answer $x$"), r"\answer $x$");
    assert_eq!(shown(r"\newcommand\answer[1]{<#1>}\answer{2}"), "<2>");
}

#[test]
fn macros_that_do_not_end_are_noticed() {
    for text in [r"\def\a{\a}\a", r"\def\a{\b\b}\def\b{\a\a}\a", r"\def\a{x\a\a}\a"] {
        assert!(expanded(text).is_err(), "{text}");
    }
}

#[test]
fn macros_take_no_more_than_a_paper_may() {
    // Sixty doublings of nothing; a long argument that is used often; more arguments than TeX has.
    let names: Vec<char> = ('a'..='z').chain('A'..='Z').collect();
    let doubling = |base: &str| {
        let first = format!("\\def\\a{{{base}}}");
        let each = names.windows(2).map(|w| format!("\\def\\{}{{\\{}\\{}}}", w[1], w[0], w[0]));
        format!("{first}{}\\Z", each.collect::<String>())
    };
    // The one that the text calls is named, not one of those within.
    for base in ["", "x"] {
        let after_another = format!("\\def\\other{{o}}\\other {}", doubling(base));
        assert_eq!(expanded(&after_another).map_err(|e| e.name), Err("Z".to_owned()));
    }
    let often = format!("\\def\\a#1{{{}}}\\a{{{}}}", "#1".repeat(10_000), "x".repeat(10_000));
    assert!(expanded(&often).is_err());
    assert_eq!(shown(r"\newcommand{\a}[99999999999]{x}\a bcdefghijkl"), "xkl");
}

#[test]
fn places_are_those_of_the_call() {
    let text = r"\def\a{xy} \a z";
    let all = expanded(text).expect("ends");
    assert!(all.iter().filter(|t| t.text == "x" || t.text == "y").all(|t| &text[t.span.clone()] == r"\a"));
}

#[test]
fn unfinished_definitions_do_not_panic() {
    let text = r"\newcommand{\a}[2][x]{\b#1#2}\def\c#1{\let\d=\a}\DeclareMathOperator*{\t}{t}\a[\c{y}{z\d{w}";
    for end in 0..text.len() {
        let _ = expanded(&text[..end]);
    }
}

#[test]
fn unfinished_conditions_do_not_panic() {
    let text = r"\newif\ifd\unless\ifd\ifx\a\b\iftoggle{a}{b}{\ifdefined\x\else}\fi\let\ifmy\iftrue\unless\ifmy\global\def\A{x}\edef\B{\A}\frac1\B$$a$$\setboolean{d}{true}";
    for end in 0..text.len() {
        let _ = expanded(&text[..end]);
        let _ = expanded(&text[end..]);
    }
}
