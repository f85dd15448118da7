//! What LaTeX prints of macros, groups, conditions and boxes, and what `lint` says of it: nothing is judged that is not printed, and nothing that is
//! printed is passed over without a word.

use rederive::check::Limits;
use rederive::diag::Source;
use rederive::lint::{self, Word};
use rederive::paper;

use Word::{Condition, Defines, Follows, NotRead, Wrong};

/// A formula that is called wrong where it is read.
const SLIP: &str = r"\sin2x=\sin x\cos x";

/// The words on the relations of a document, and its notes.
fn read(tex: &str) -> (Vec<Word>, Vec<String>) {
    let text =
        format!("\\documentclass{{article}}\\begin{{document}}\n{}\n\\end{{document}}\n", tex.replace("SLIP", SLIP));
    let paper = paper::parse(Source { path: "p.tex".into(), text }, String::new()).unwrap_or_else(|d| panic!("{d}"));
    let words = lint::lint(&paper, &Limits::default()).judgements.into_iter().map(|j| j.word).collect();
    (words, paper.notes.into_iter().map(|n| n.message).collect())
}

fn are(cases: &[(&str, &[Word])]) {
    for (tex, words) in cases {
        assert_eq!(read(tex).0, *words, "{tex}");
    }
}

#[test]
fn a_macro_as_an_argument_is_all_that_it_prints() {
    are(&[
        (r"\newcommand{\xx}{x+y} \[\frac1\xx=\frac1x+y\]", &[Condition]),
        (r"\newcommand{\xx}{x+y} \[\dfrac\xx2=\frac x2+\frac y2\]", &[Follows]),
        (r"\newcommand{\ab}{ab} \[g=\frac1\ab\] hence \[g^2=\frac{b^2}{a^2}\]", &[Defines, Condition]),
        (r"\newcommand{\ab}{ab} \[g=\frac1\ab\] hence \[g^2=\frac1{a^2b^2}\]", &[Defines, Follows]),
        (r"\newcommand{\kT}[1][]{k#1 T} \[\frac1\kT=\frac Tk\]", &[Condition]),
        (r"\newcommand{\kT}[1][]{k#1 T} \[\frac1\kT=\frac1{kT}\]", &[Follows]),
        // A space behind the sign of a name's meaning is not the meaning.
        ("\\let\\k= \\kappa \\[\\k+y=y\\]", &[Condition]),
        ("\\let\\k= \\kappa \\[\\k+y=y+\\kappa\\]", &[Follows]),
    ]);
}

#[test]
fn a_definition_ends_with_its_group() {
    for inside in [
        r"{\renewcommand{\A}{b} x}",
        r"\begingroup\renewcommand{\A}{b}\endgroup",
        r"$\def\A{b}x$",
        r"$$\def\A{b}$$",
        r"\begin{center}\renewcommand{\A}{b}\end{center}",
    ] {
        let tex = format!(r"\newcommand{{\A}}{{a}} {inside} \[\A+1=1+b\] \[\A+1=1+a\]");
        assert_eq!(read(&tex).0, [Condition, Follows], "{tex}");
    }
    are(&[
        (r"\newcommand{\k}{x}{\renewcommand{\k}{2x}} \[g=\k^2\] hence \[g+1=x^2+1\]", &[Defines, Follows]),
        (r"\newcommand{\A}{a}{\renewcommand{\A}{b} \[\A+1=1+b\]}", &[Follows]),
        (r"\newcommand{\A}{a}{\gdef\A{b}} \[\A+1=1+b\]", &[Follows]),
        (r"\def\A{x}\edef\B{\A}\def\A{y} \[\B+1=1+x\] \[\B+1=1+y\]", &[Follows, Condition]),
        (r"\providecommand{\pi}{3} \[\pi+1=4\]", &[Condition]),
        (r"\providecommand{\mine}{3} \[\mine+1=4\]", &[Follows]),
    ]);
}

#[test]
fn a_branch_that_is_not_known_is_told_and_not_judged() {
    for tex in [
        r"\newif\ifd\dtrue \ifd \ifnum0=1 p\else \[SLIP\]\fi\fi",
        r"\ifnum0=1 \[SLIP\]\fi",
        r"\if0\[SLIP\]\fi",
        r"\ifodd2 \[SLIP\]\fi",
        r"\ifdim1pt=2pt \[SLIP\]\fi",
        r"\ifcase1 \[SLIP\]\or a\fi",
        r"\ifx\a\b\else\[SLIP\]\fi",
        r"\ifdefined\foo\[SLIP\]\fi",
        r"\unless\ifx\a\b\[SLIP\]\fi",
        r"\iftoggle{d}{\[SLIP\]}{}",
        r"\ifbool{d}{}{$SLIP$}",
        r"\ifthenelse{\boolean{d}}{\[SLIP\]}{}",
        r"\ifnum0=1 \newcommand{\s}{\sin x}\fi \[\sin2x=\s\cos x\]",
    ] {
        let (words, notes) = read(&format!(r"{tex} \[2x=x+x\]"));
        assert_eq!(words, [NotRead, Follows], "{tex}");
        assert!(notes.iter().any(|n| n.contains("is not known")), "{tex}: {notes:?}");
    }
    are(&[
        (r"\newcommand{\x}{a} \ifnum0=1 \renewcommand{\x}{b}\fi \[\x+1=1+b\] \[\x+1=1+a\]", &[NotRead, NotRead]),
        (r"\makeatletter\@ifundefined{c}{\newcommand{\x}{a}}{\newcommand{\x}{b}}\makeatother \[\x+1=1+b\]", &[NotRead]),
        // What a branch may define anew is not defined any more.
        (r"\[f=x^2\] \ifx\a\b\[f=x^3\]\fi Hence \[f+1=x^2+1\]", &[Defines, NotRead, Condition]),
    ]);
}

#[test]
fn a_branch_that_is_known_is_read_alone() {
    for tex in [
        r"\iffalse \[SLIP\]\fi",
        r"\iftrue \else \[SLIP\]\fi",
        r"\iffalse \iftrue\[SLIP\]\else\[SLIP\]\fi\[SLIP\]\fi",
        r"\newif\ifd \ifd \[SLIP\] \ifx\a\b\else\[SLIP\]\fi \[SLIP\]\fi",
        r"\newif\ifd\dtrue \ifd \else\[SLIP\]\fi",
        r"\newif\ifd\dtrue \unless\ifd \[SLIP\]\fi",
        r"\let\ifmy\iffalse \ifmy \[SLIP\]\fi",
    ] {
        let (words, notes) = read(&format!(r"{tex} \[2x=x+x\]"));
        assert_eq!((words, notes), (vec![Follows], Vec::new()), "{tex}");
    }
    are(&[(r"\newif\ifd\dtrue \ifd \[SLIP\]\fi", &[Wrong]), (r"\iffalse\else\[SLIP\]\fi", &[Wrong])]);
}

#[test]
fn what_is_printed_is_read_or_told() {
    are(&[
        (r"\newtheorem{comment}{C} \begin{comment}\[SLIP\]\end{comment}", &[Wrong]),
        (r"\newenvironment{minted}{}{} \begin{minted}\[SLIP\]\end{minted}", &[Wrong]),
        (r"\begin{subeqnarray} \sin2x&=&\sin x\cos x\end{subeqnarray}", &[Wrong]),
        (r"Let \ensuremath{f=x^2}. Then \[f+1=x^2+1\]", &[Defines, Follows]),
        (r"\[g=f+1\quad\text{where $f=x^2$}\]", &[Defines, Defines]),
        (r"\[g=f+1\quad\text{if $f=x^2$}\] Hence \[f+1=x^2+1\]", &[Condition, Condition, Condition]),
        (r"\[g=f+1\quad\text{if $a=b$ and $f=x^2$}\]", &[Condition, Condition, Condition]),
        (r"\begin{align} f&=x^2 \intertext{and, since $g=x^3$,} h&=g+1\end{align}", &[Defines, Defines, Condition]),
        (r"\url{http://a%20b} $f=x^2$", &[Defines]),
    ]);
    for tex in [
        r"\begin{numcases}{f=} x & a\end{numcases}",
        r"\begin{mathpar} a=b \end{mathpar}",
        r"\sbox0{$SLIP$}",
        r"\savebox{\b}[3cm]{$SLIP$}",
        r"\sbox\b{$SLIP$}",
        r"\setbox0=\hbox{$SLIP$}",
    ] {
        let (words, notes) = read(&format!(r"{tex} \[2x=x+x\]"));
        assert_eq!(words, [Follows], "{tex}");
        assert!(notes.iter().any(|n| n.contains("not read")), "{tex}: {notes:?}");
    }
}

#[test]
fn what_is_not_printed_is_not_read() {
    for tex in [
        r"\begin{BVerbatim}\[SLIP\]\end{BVerbatim}",
        r"\begin{tcblisting}{}\[SLIP\]\end{tcblisting}",
        r"\begin{pycode}$SLIP$\end{pycode}",
        r"\lstinline|$SLIP$|",
        r"\mintinline{tex}{$SLIP$}",
        r"\url{$SLIP$}",
        r"\index{$SLIP$}",
        r"\typeout{$SLIP$}",
        r"\hypersetup{pdftitle={$SLIP$}}",
        r"\phantom{$SLIP$}",
        r"\makeatletter\@gobble{$SLIP$}\makeatother",
        r"\NewEnviron{hide}{}\begin{hide}\[SLIP\]\end{hide}",
        r"\excludecomment{hide}\begin{hide}\[SLIP\]\end{hide}",
        r"\excludeversion{hide}\begin{hide}\[SLIP\]\end{hide}",
        r"\excludeversion{hide}\processifversion{hide}{\[SLIP\]}",
        r"\NewDocumentEnvironment{hide}{+b}{}{}\begin{hide}\[SLIP\]\end{hide}",
        r"\newenvironment{hide}{\setbox0\vbox\bgroup}{\egroup}\begin{hide}\[SLIP\]\end{hide}",
        r"\let\hide\comment\let\endhide\endcomment\begin{hide}\[SLIP\]\end{hide}",
        r"\begin {comment}\[SLIP\]\end {comment}",
        "\\begin% a\n  {comment}\\[SLIP\\]\\end{comment}",
        r"\verb |$SLIP$|",
    ] {
        assert_eq!(read(&format!(r"{tex} \[2x=x+x\]")).0, [Follows], "{tex}");
    }
    are(&[
        (r"\[2x=x+x\] \endinput \[SLIP\]", &[Follows]),
        (r"\NewDocumentEnvironment{show}{+b}{#1}{}\begin{show}\[SLIP\]\end{show}", &[Wrong]),
        (r"\includeversion{show}\begin{show}\[SLIP\]\end{show}", &[Wrong]),
        (r"\begin{comment}\begin{comment}\end{comment}\[SLIP\]\end{comment}", &[Wrong]),
    ]);
}

/// The words on the relations of a page, each with its line and its column.
fn of_page(name: &str, text: &str) -> Vec<(Word, usize, usize)> {
    let paper = paper::parse(Source { path: name.into(), text: text.replace("SLIP", SLIP) }, String::new())
        .unwrap_or_else(|d| panic!("{d}"));
    let place = |j: lint::Judgement| {
        let (line, column) = paper.line_and_column(&j.span);
        (j.word, line, column)
    };
    lint::lint(&paper, &Limits::default()).judgements.into_iter().map(place).collect()
}

#[test]
fn a_page_is_read_as_it_is_rendered() {
    for hidden in [
        "-\t\t$$SLIP$$",
        "> ```\n> $SLIP$\n",
        "[//]: # ($SLIP$)",
        "![$SLIP$](a.png)",
        "[a](b \"$SLIP$\")",
        "<img alt=\"$SLIP$\">",
        "<template>\n\n$$SLIP$$\n\n</template>",
        "<div hidden>\n\n$$SLIP$$\n\n</div>",
        "```{code}\n$SLIP$\n```",
        r"\$SLIP\$",
    ] {
        let words: Vec<Word> = of_page("p.md", &format!("a\n\n{hidden}\n\n$2x=x+x$\n")).iter().map(|f| f.0).collect();
        assert_eq!(words, [Follows], "{hidden}");
    }
    for shown in [
        "-\t$$SLIP$$",
        "1.\ta $SLIP$",
        "- a\n\n\t$$SLIP$$",
        "> ```math\n> SLIP\n",
        "```{note}\n$SLIP$\n```",
        "```{math}\n:label: a\nSLIP\n```",
        "a {math}`SLIP`",
        "<details>\n\n$$SLIP$$\n\n</details>",
        "[^1]: a $SLIP$",
        "[$SLIP$](a)",
    ] {
        let words: Vec<Word> = of_page("p.md", &format!("a\n\n{shown}\n\n$2x=x+x$\n")).iter().map(|f| f.0).collect();
        assert_eq!(words, [Wrong, Follows], "{shown}");
    }
    // A heading begins a part, in which names mean something else.
    for heading in ["## B", "B\n===", "---", "**B.**", "<h2>B</h2>"] {
        let found = of_page("p.md", &format!("## A\n\n$$E=ab+c.$$\n\n{heading}\n\nWe get $$2E=2ab-2c.$$\n"));
        assert!(found.iter().all(|f| f.0 != Wrong), "{heading}");
    }
    for definition in ["$\\newcommand{\\A}{a}$", "$$\\newcommand{\\A}{a}$$"] {
        let found = of_page("p.md", &format!("{definition}\n\n# b\n\n$\\A+1=1+a$\n"));
        assert_eq!(found.iter().map(|f| f.0).collect::<Vec<_>>(), [Follows], "{definition}");
    }
}

/// Line ends of Unix, of Windows, of old Macintoshes, and all of them in one file: the same is read, in the same places.
#[test]
fn lines_end_as_they_do_for_tex() {
    let tex = "% \\[SLIP\\]\nLet $a=b+1$.\n\nHence\n\\begin{align}\n  2x &= x+x \\\\ % +1\n  SLIP\n\\end{align}\n\\begin% a\n{comment}\n$SLIP$\n\\end{comment}\né $a+1=b+2$, $2x=x+x$\n";
    let page = "---\na: b\n---\nLet $a=b+1$.\n\n- $$\n  SLIP\n  $$\n\n    $a+1=b+2$\n\n```\n$SLIP$\n```\n\n> é $2x=x+x$\n> ```math\n> 2x=x+x % a\n> ```\n";
    for (name, text) in [("p.tex", tex), ("p.md", page)] {
        let plain = of_page(name, text);
        assert!(
            plain.len() > 3 && plain.iter().any(|f| f.0 == Wrong) && plain.iter().any(|f| f.0 == Follows),
            "{plain:?}"
        );
        let mut mixed = String::new();
        for (k, line) in text.split_inclusive('\n').enumerate() {
            mixed.push_str(line.trim_end_matches('\n'));
            mixed.push_str(["\n", "\r\n", "\r"][k % 3]);
        }
        // A return before a break is one end with it.
        let mixed = mixed.replace("\r\n\r\r", "\r\n\n\r");
        for other in [text.replace('\n', "\r\n"), text.replace('\n', "\r"), mixed] {
            assert_eq!(of_page(name, &other), plain, "{other:?}");
        }
    }
}

#[test]
fn scripts_that_stand_behind_each_other_are_not_read() {
    for tex in [
        r"\[{x_a}_{bc}=x_{abc}\]",
        r"\[{x_a}_b-x_{ab}=0\]",
        r"\[T^{a}{}_{b}=T^a_b\]",
        r"\[T_{a}{}^{b}=T^{b}{}_{a}\]",
        r"\[2{}_aT=2_aT\]",
        r"\[x\,{}_2F=x_2F\]",
        r"\[T^a\,_b=T^a_b\]",
        r"\[T_{a}^{\ b}=T^{b}_{\ a}\]",
        r"\[x_{a}{}_{b}=x_{ab}\]",
    ] {
        assert_eq!(read(tex).0, [NotRead], "{tex}");
    }
    are(&[(r"\[x_a{}^2=x_a^2\]", &[Follows]), (r"\[(a+b){}^2=a^2+2ab+b^2\]", &[Follows])]);
}

#[test]
fn an_environment_of_another_file_is_one_of_the_paper() {
    let folder = std::env::temp_dir().join(format!("rederive-environments-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let files = [
        ("own.sty", r"\newenvironment{comment}{\it}{}"),
        (
            "paper.tex",
            r"\documentclass{article}\usepackage{own}\begin{document}\begin{comment}\[SLIP\]\end{comment}\end{document}",
        ),
        ("main.tex", r"\documentclass{book}\newtheorem{comment}{C}\begin{document}\include{chapter}\end{document}"),
        ("chapter.tex", r"\begin{comment}\[SLIP\]\end{comment}"),
    ];
    for (name, text) in files {
        std::fs::write(folder.join(name), text.replace("SLIP", SLIP)).expect("written");
    }
    for name in ["paper.tex", "main.tex", "chapter.tex"] {
        let paper = paper::read(&folder.join(name)).unwrap_or_else(|d| panic!("{d}"));
        let words: Vec<Word> = lint::lint(&paper, &Limits::default()).judgements.iter().map(|j| j.word).collect();
        assert_eq!(words, [Wrong], "{name}");
    }
    std::fs::remove_dir_all(&folder).expect("removed");
}

#[test]
fn what_is_not_understood_is_not_judged() {
    let doubted = [
        r"\newif\ifq \ifx a b\let\s\sin\else\let\s\cos\fi \[ \s(2x)=2\s x\cos x \]",
        r"\ifx a b\def\hide#1{}\else\def\hide#1{#1}\fi \hide{\[ SLIP \]}",
        r"\ifx a b\newenvironment{hide}{\comment}{\endcomment}\else\newenvironment{hide}{}{}\fi \begin{hide}\[ SLIP \]\end{hide}",
        r"\ifx a b\endinput\fi \[ SLIP \]",
        r"\ifx a b\end{document}\fi \[ SLIP \]",
        r"\newif\ifd\DeclareOption{d}{\dtrue}\ifd\else \[ SLIP \]\fi",
        r"\IfStrEq{a}{b}{\[ SLIP \]}{}",
        r"\newcommand{\x}{\sin2x}\RenewDocumentCommand{\x}{d() m}{3y} \[ \x = \sin x\cos x \]",
        r"\newcommand{\x}{\sin2x}\appto\x{+1} \[ \x = \sin x\cos x \]",
        r"\newcommand{\xx}{x+y} \[ \hat\xx=\hat x \]",
        r"\newif\ifs\ifs\includecomment{p}\else\excludecomment{p}\fi \begin{p}\[ SLIP \]\end{p}",
        r"\newif\ifs\ifs\newenvironment{p}{}{}\else\newenvironment{p}{\comment}{\endcomment}\fi \begin{p}\[ SLIP \]\end{p}",
    ];
    for tex in doubted {
        let (words, notes) = read(tex);
        assert!(words == [NotRead] && notes.len() == 1, "{tex}: {words:?} {notes:?}");
    }
    for tex in [
        r"\newif\ifd\booltrue{d}\ifd\else \[ SLIP \]\fi",
        r"\newif\ifd\csname dtrue\endcsname\ifd\else \[ SLIP \]\fi",
        r"\makeatletter\@secondoftwo{\[ SLIP \]}{}",
    ] {
        assert_eq!(read(tex).0, [], "{tex}");
    }
    // What is made of arguments is a formula, perhaps, and told.
    let (words, notes) = read(r"\[(a+b)^2=a^2+2ab+b^2\] \NewDocumentCommand{\foo}{d() m}{\[#2\]}\foo{SLIP}");
    assert!(words == [Follows] && notes.len() == 1, "{words:?} {notes:?}");
    are(&[
        (r"\cspreto{equation}{\x}\csappto{endequation}{\y}\begin{equation} SLIP \end{equation}", &[Wrong]),
        (r"\newenvironment{eq}{\align}{\endalign}\begin{eq} SLIP \end{eq}", &[Wrong]),
        (r"\def\eq{\begin{equation}}\def\endeq{\end{equation}}\begin{eq} SLIP \end{eq}", &[Wrong]),
        (r"\let\eq\equation\let\endeq\endequation\begin{eq} SLIP \end{eq}", &[Wrong]),
        (r"\newcommand{\x}{a}\expandafter\def\csname x\endcsname{b} \[ \x+1=1+b \]", &[Follows]),
        (r"\newcommand{\x}{a}\let\bg\begingroup\let\eg\endgroup \bg\renewcommand{\x}{b}\eg \[ \x+1=1+a \]", &[Follows]),
        (r"\newcommand{\x}{a}\begin{align*} c&=d \renewcommand{\x}{b}\\ \x+1&=1+a \end{align*}", &[Condition, Follows]),
    ]);
}

#[test]
fn what_is_not_printed_and_never_ends_is_told() {
    let (words, notes) = read(r"\[(a+b)^2=a^2+2ab+b^2\] \begin{comment} \[ SLIP \]");
    assert!(
        words == [Follows] && notes.iter().any(|n| n.starts_with("nothing ends this environment")),
        "{words:?} {notes:?}"
    );
}

#[test]
fn words_and_full_stops_within_a_formula_are_parts_of_it() {
    for tex in [
        r"\[\text{Tr }A=2ab\]",
        r"\[\mbox{rank }A=2\]",
        r"\[\text{minus }\frac{dV}{dx}=-kx\]",
        r"\[\text{half of }(a+b)^2=\frac12a^2+ab+\frac12b^2\]",
        r"\[\text{the mean of }x=2a\]",
        r"\[x=2\text{Tr }A\]",
        r"\[x=a\text{ Tr }A\]",
        r"\[v=s\text{ per }t\]",
        r"\[\mbox{2}(a+b)=2a+2b\]",
        r"\[\text{-}x=a\]",
        r"\[H=ab\text{ + h.c.}\]",
        r"\[(x+y)^2=x^2-2xy+y^2\text{ + c.c.}\]",
        r"\[H=ab+h.c.\]",
        r"\[F.s=W\]",
        r"\[x=2.a\]",
        r"\[H=ab...\]",
        // Uncertainties, temperatures, term symbols, values at a place.
        r"\[x=1.50(2)a=1.50a\]",
        r"\[x=1.5^{+1}a=1.5a\]",
        r"\[T=20^\circ C\]",
        r"\[T=20\,^\circ\mathrm{C}\]",
        r"\[2\,^3P=8P\]",
    ] {
        assert_eq!(read(tex).0, [NotRead], "{tex}");
    }
    are(&[
        (r"\[F=-kx\]\[F(-x)=kx\]", &[Defines, NotRead]),
        (r"\[i=\frac VR\]\[i^2R=-R\]", &[NotRead, NotRead]),
        (r"\[\pi=p-A\]\[\sin\pi=0\]", &[NotRead, NotRead]),
        (r"\[i=\sqrt{-1}\]\[(1+i)^2=2i\]", &[Condition, Follows]),
        (r"\[y=ax\]\[y\left(-x\right)=-ax\]", &[Defines, NotRead]),
        (r"\[\text{energy: }(a+b)^2=a^2+2ab+b^2\]", &[Follows]),
        (r"\[\text{We get }(a+b)^2=a^2+2ab+b^2.\]", &[Follows]),
        (r"\[a=b.\text{ Then } (c+d)^2=c^2+2cd+d^2\]", &[Condition, Follows]),
        (r"\[2(0.5)a=a\]", &[Follows]),
        (r"\[x=90^\circ\]", &[Condition]),
    ]);
}

#[test]
fn braces_of_a_second_argument_stay() {
    for tex in [
        r"\[\frac1{1+}\frac12=\frac23\]",
        r"\[\frac1{1+}\frac1{1+}\frac12=\frac35\]",
        r"\[\frac1{x+}z=\frac1x+z\]",
        r"\[\sqrt[3]{a+}b=\sqrt[3]a+b\]",
        r"\[\binom1{2+}3=4\]",
    ] {
        assert_eq!(read(tex).0, [NotRead], "{tex}");
    }
    are(&[(r"\[{a+} {b} = b+a\]", &[Follows]), (r"\[x_1{a+}b=b+ax_1\]", &[Follows])]);
}

#[test]
fn a_factor_in_parentheses_behind_a_small_space_is_no_number_for_sure() {
    for tex in [
        r"\[3\cdot4=(6)\ (2) .\]",
        r"\[3=3\;(2)\]",
        r"\[ab=b\;(a)\]",
        r"\[W=F\ (d)\]",
        r"\[y=2x\ (2)\]",
        r"\[x+x=x~(2)\]",
        r"\[x+x=2x\ (2.1)\]",
    ] {
        assert_eq!(read(tex).0, [NotRead], "{tex}");
    }
    for space in [r"\quad", r"\qquad", r"\hfill", r"\hspace{2cm}", r"\ \ \ ", r"\hskip2em"] {
        let tex = format!(r"\[x+x=2x{space}(2)\]");
        assert_eq!(read(&tex).0[0], Follows, "{tex}");
    }
    // The numbers of the paper are set so throughout.
    are(&[
        (r"\[x+x=2x\ (1)\] \[3x=x+2x\ (2)\] \[y+y=2y\ (3)\]", &[Follows; 3]),
        (r"\[x+x=2x\ (1)\] \[3x=x+2x\ (3)\]", &[NotRead; 2]),
        (r"\[E=mc^2\ (1)\] \[2E=2mc^2\ (2)\]", &[Defines, Follows]),
        (r"\[x+x=2x\eqno(2)\]", &[Follows]),
        (r"$$x+x=2x\leqno{(2)}$$", &[Follows]),
        (r"\[x+x=2x\ (1)\] \[6=3\ (2)\]", &[Follows, NotRead]),
    ]);
}

#[test]
fn letters_of_mathematics_are_factors_or_are_not_read() {
    for tex in [r"\[at\,v=x\]", r"\[as\,2=2\]", r"\[in\,\omega=\lambda\]", r"\[si\,r=U\]", r"\[x+0=x\; if\; 2=3\]"] {
        assert!(read(tex).0.iter().all(|word| *word == NotRead), "{tex}: {:?}", read(tex));
    }
    are(&[
        (r"\[x+x=2x\quad if\quad x>0\]", &[Follows, Condition]),
        (r"\[x+x=2x\;\mathrm{if}\; x>0\]", &[Follows, Condition]),
    ]);
}

#[test]
fn a_length_parts_numbers() {
    for space in [r"\hspace{1em}", r"\hspace*{1em}", r"\kern1pt", r"\hskip1em", r"\mskip3mu", r"\mkern3mu", r"\ "] {
        for tex in [format!(r"\[2{space}3=23\]"), format!(r"\[7F+16F=2{space}3F\]")] {
            assert_eq!(read(&tex).0, [NotRead], "{tex}");
        }
    }
}

#[test]
fn a_formula_that_is_empty_ends_nothing() {
    are(&[
        (r"$\newcommand{\R}{\mathbb{R}}$ We have $2^3=9$ and $2^4=17$.", &[Wrong; 2]),
        (r"\newcommand{\x}{} $\x$ We have $2^3=9$ and $2^4=17$.", &[Wrong; 2]),
        (r"\newcommand{\dd}{$$} \dd 2^3=9 \dd", &[Wrong]),
        (r"$$2^3=9$$ $2^4=17$", &[Wrong; 2]),
    ]);
}

#[test]
fn what_is_struck_out_is_not_said() {
    for command in ["deleted", "deleted[id=a]", "st", "sout", "xout", "cancel", "bcancel", "xcancel", "hcancel"] {
        for formula in ["$2^3=9$", r"\[2^3=9\]", r"so \(2^3=9\) and $2^3=9$"] {
            let tex = format!(r"\{command}{{{formula}}} and $2^4=17$");
            assert_eq!(read(&tex).0, [Wrong], "{tex}");
        }
    }
    are(&[
        (r"\replaced{$2^3=9$}{$2^3=7$}", &[Wrong]),
        (r"\replaced[id=a]{so $2^3=8$}{$2^3=9$} and $2^4=17$", &[Follows, Wrong]),
        (r"\added{$2^3=9$}", &[Wrong]),
    ]);
}

#[test]
fn what_is_not_printed_as_a_formula_is_none() {
    for tex in [
        r"\label{$2^3=9$}",
        r"\PackageWarning{a}{$2^3=9$}",
        r"\settowidth{\x}{$2^3=9$}",
        r"\path|$2^3=9$|",
        r"\detokenize{$2^3=9$}",
        r"\url{$2^3=9$}",
        r"\url|$2^3=9$|",
        r"\errmessage{$2^3=9$}",
    ] {
        assert_eq!(read(&format!("{tex} and $2^4=17$")).0, [Wrong], "{tex}");
    }
    let (words, notes) = read(r"\begin{lrbox}{\bx} $2^3=9$ \end{lrbox} and $2^4=17$");
    assert_eq!(words, [Wrong]);
    assert!(notes.iter().any(|n| n.contains("in a box")), "{notes:?}");
    are(&[(r"\begin{lrbox}{\bx} $2^3=9$ \end{lrbox}\fbox{\usebox{\bx}}", &[Wrong])]);
}

#[test]
fn a_brace_that_ends_what_a_macro_takes_stays() {
    are(&[
        (r"\def\x#1#{q} \[\x a{b}=qb\] \[x+x=2x\]", &[Follows; 2]),
        (r"\def\x#{q+} \[\x{1}=q+1\] \[x+x=2x\]", &[Follows; 2]),
    ]);
}

/// The words on what a file of this name has, and its notes.
fn read_file(name: &str, text: &str) -> Result<(Vec<Word>, Vec<String>), String> {
    let source = Source { path: name.into(), text: text.into() };
    let paper = paper::parse(source, String::new()).map_err(|d| d.message.clone())?;
    let words = lint::lint(&paper, &Limits::default()).judgements.into_iter().map(|j| j.word).collect();
    Ok((words, paper.notes.into_iter().map(|n| n.message).collect()))
}

#[test]
fn dollars_of_money_and_signs_of_html_in_markdown() {
    for (text, words) in [
        ("USD$5 and $2^3=9$ then $5.", &[Wrong][..]),
        ("$5 or $6, and $2^3=9$", &[Wrong]),
        ("For $x &gt; 0$ and $x&lt;1$ and $2^3&equals;9$.", &[Condition, Condition, Wrong]),
        ("$$\\begin{aligned} x+x &amp;= 2x \\\\ &amp;=3x-x\\end{aligned}$$", &[Follows]),
    ] {
        assert_eq!(read_file("p.md", text).map(|(words, _)| words).as_deref(), Ok(words), "{text}");
    }
}

#[test]
fn a_notebook_is_its_text() {
    let text = r#"{"cells":[
        {"cell_type":"markdown","metadata":{},"source":["We have\n","$2^3=9$."]},
        {"cell_type":"code","source":"$2^4=17$","outputs":[{"text":"$2^4=17$"}]},
        {"cell_type":"raw","source":"$2^4=17$"},
        {"cell_type":"raw","metadata":{"raw_mimetype":"text/latex"},"source":"\\[2^5=33\\]"},
        {"cell_type":"markdown","source":"Cost: $5.\n\n$$x+x=2x$$"}],"nbformat":4}"#;
    let (words, notes) = read_file("p.ipynb", text).expect("it is read");
    assert_eq!(words, [Wrong, Wrong, Follows]);
    assert!(notes.iter().any(|n| n.contains("cell 1 begins at line 1, 4 at 6, 5 at 10")), "{notes:?}");
    assert!(read_file("p.ipynb", "{").is_err_and(|why| why.contains("not JSON")));
    assert!(read_file("p.ipynb", r#"{"a":1}"#).is_err_and(|why| why.contains("`cells`")));
}

#[test]
fn what_is_neither_latex_nor_markdown_is_refused() {
    for name in ["p.rst", "p.html", "p.py", "p.bib", "p.docx", "p.pdf", "p.json"] {
        let why = read_file(name, "$2^3=9$").expect_err(name);
        assert!([".tex", ".md", ".ipynb", "standard input"].iter().all(|kind| why.contains(kind)), "{why}");
    }
    for name in ["p", "-", "p.tex", "p.ltx", "p.txt", "p.sty", "p.Rmd", "p.qmd", "p.v2"] {
        assert_eq!(read_file(name, "$2^3=9$").map(|(words, _)| words).as_deref(), Ok(&[Wrong][..]), "{name}");
    }
}
