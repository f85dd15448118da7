//! What is left of pages, without blanks.

use super::printed;

/// What is left, without blanks.
fn left(text: &str) -> String {
    let out = printed(text);
    assert_eq!(out.len(), text.len(), "{text}");
    out.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn what_is_not_printed_is_blank() {
    assert_eq!(left("a <!-- $$f=x^3$$\n\n$g$ --> b"), "a b");
    assert_eq!(left("Text\n\n    $$f=x^3$$\n\tmore\n\n    more\nb"), "Text b");
    assert_eq!(left("Text\n    $f=x^3$"), "Text $f=x^3$", "code does not interrupt a paragraph");
    for name in ["pre", "code", "script", "STYLE", "textarea"] {
        assert_eq!(left(&format!("a\n<{name} class=\"x\">\n$f$\n\n$g$</{name}>\nb $h$")), "a b $h$", "{name}");
    }
    assert_eq!(left("<preface> $f$"), "<preface> $f$");
    assert_eq!(left("---\ntitle: $f=x^3$\n---\n$g$"), "$g$");
    assert_eq!(left("---\n\n$f$"), "--- $f$", "a line alone");
    assert_eq!(left("a `$f$ x\n$g$` b"), "a b");
    assert_eq!(left("```\n$f$\n````\n$g$"), "$g$");
    assert_eq!(left("<!-- not closed\n\n$f$"), "");
    assert_eq!(left("a < b <!- $f$"), "a < b <!- $f$");
}

#[test]
fn what_belongs_to_a_list_is_no_code() {
    assert_eq!(left("- item\n\n    $$f$$\n\n    1. more\n\n        $$g$$"), "- item $$f$$ 1. more $$g$$");
    assert_eq!(left("10. item\n\n    $$f$$"), "10. item $$f$$");
    assert_eq!(left("- item\n\n      $$f$$\n\ntext\n\n    $$g$$"), "- item text");
    for block in ["!!! note", "[^1]: note", ": meaning"] {
        assert_eq!(left(&format!("{block}\n\n    $f$")), format!("{block} $f$"));
    }
    assert_eq!(left("$$\nf\n\n    +g\n$$"), "$$ f +g $$", "within mathematics there is none");
}

#[test]
fn marks_of_quotations_go() {
    assert_eq!(left("> $$\n> f=x^2\n> $$\nb"), "$$ f=x^2 $$ b");
    assert_eq!(left("> > $$\n> > f\n> > > g\n>> $$"), "$$ f > g $$");
    assert_eq!(left("$$\nf\n> g\n$$"), "$$ f > g $$", "a sign of mathematics");
    assert_eq!(left("> ```math\n> f > g\n> ```\n> b"), "$$ f > g $$ b");
    assert_eq!(left(">     $$f$$"), "");
}

#[test]
fn a_percent_sign_is_a_comment_in_mathematics_alone() {
    assert_eq!(left("50% of $f$, $$\nf = x % +1 $\n+2$$ b"), "50 of $f$, $$ f = x +2$$ b");
    assert_eq!(left("$f % x$ and $g$"), "$f $ and $g$");
    assert_eq!(left(r"$f\% x$ \% \$ %"), r"$f\% x$ \ \$");
    assert_eq!(left("$5 and 10% of $6, $f$"), "5 and 10 of 6, $f$");
    assert_eq!(left("$x &gt; y&lt;z&amp;&equals;&nope;$ &gt;"), "$x > y< z& = &nope;$ &gt;");
    assert_eq!(left("```math\nf % x\n```"), "$$ f $$");
    assert_eq!(left("\\begin{align}\nf % x\n\\end{align} %"), "\\begin{align} f \\end{align}");
    assert_eq!(left("a $`f%x`$ b"), "a $ f $ b");
}

#[test]
fn tabs_stand_behind_marks_and_marks_behind_marks() {
    assert_eq!(left("-\t$$f$$"), "- $$f$$");
    assert_eq!(left("1.\ttext $f$\n\n\t$$g$$"), "1. text $f$ $$g$$");
    assert_eq!(left("-\ta\n\n\t$$f$$\n\n\t    $$g$$"), "- a $$f$$");
    assert_eq!(left("-\t\t$$f$$"), "-", "code behind a mark");
    assert_eq!(left("- 10. a\n\n      $$f$$\n\n          $$g$$"), "- 10. a $$f$$");
    assert_eq!(left("- > $$\n  > f\n  > $$\n  > `$g$`"), "- $$ f $$");
    assert_eq!(left("* * *\n\n    $$f$$"), "* * *", "a line that is drawn is no item");
    assert_eq!(left("- a\n\n  b $f$\n\n  $$g$$"), "- a b $f$ $$g$$", "paragraphs of an item");
}

#[test]
fn a_fence_ends_with_what_it_stands_in() {
    assert_eq!(left("> ```\n> $f$\n\n$g$"), "$g$");
    assert_eq!(left("> ```\n> $f$\n$g$"), "$g$");
    assert_eq!(left("> > ```\n> > $f$\n> $g$"), "$g$");
    assert_eq!(left("- ```\n  $f$\n\n  $g$\n\n$h$"), "- $h$");
    assert_eq!(left("1. a\n   ```\n   $f$\nb $g$"), "1. a b $g$");
    assert_eq!(left("> ```math\n> f\n\n$g$"), "$$ f$$$g$");
    assert_eq!(left("> ```math\r\n> f\r\n$g$"), "$$ f$$$g$");
    assert_eq!(left("> ```math\n> f\n$g$"), "$g$", "there is no room for its end");
    assert_eq!(left("> $$ f\n\nb $$ $g$"), "$$ f b $$ $g$");
    assert_eq!(left("a $5\n```\n$f$\n```\nb"), "a $5 b", "no formula goes on in a block");
}

#[test]
fn directives_print_text_formulas_or_code() {
    assert_eq!(left("```{note}\n:class: tip $f$\n$g$\n```\n$h$"), "$g$ $h$");
    assert_eq!(
        left("````{prf:theorem} Of $e$\n```{math}\n:label: a\nf % x\n```\n````\n$h$"),
        "Of $e$ $$ \\label{a} f $$ $h$"
    );
    assert_eq!(left("```{note}\n```\n$f$\n```\n$g$\n```"), "$f$", "a closed one, then code");
    for name in ["code", "code-block", "code-cell", "raw", "python"] {
        assert_eq!(left(&format!("```{{{name}}}\n$f$\n```\n$g$")), "$g$", "{name}");
    }
    assert_eq!(left(":::{note}\n$f$\n:::\n$g$"), "$f$ ::: $g$");
    assert_eq!(left(":::{math}\nf\n:::\n$g$"), "$$ f $$ $g$");
    assert_eq!(left(":::{code} python\n$f$\n:::\n$g$"), "$g$");
    assert_eq!(left("a {math}`f % x` and {eq}`$g$`, {math}`` b"), "a $f $ and {eq} , {math}`` b");
}

#[test]
fn what_links_and_pictures_are_given_is_not_printed() {
    assert_eq!(left("[//]: # ($f$)\n[a]: <b> '$g$'\n[b]: /u\n\"$i$\"\n$h$"), "$h$");
    assert_eq!(left("a\n[b]: c $f$"), "a [b]: c $f$", "none interrupts a paragraph");
    assert_eq!(left("[b]: c and $f$"), "[b]: c and $f$", "none has more than a title");
    assert_eq!(left("[^1]: a $f$\n\n    b $g$"), "[^1]: a $f$ b $g$");
    assert_eq!(left("![$f$ [a]](b \"$g$\") $h$ ![$i$][c]"), "$h$");
    assert_eq!(left("![$[0,1)$](b) $h$"), "$h$");
    assert_eq!(left("a ![b $f$"), "a ![b $f$");
    assert_eq!(left("[$f$](b/$g$ '$h$')"), "[$f$]");
    assert_eq!(left("on [0,1](with $f$)"), "on [0,1](with $f$)");
    assert_eq!(left("<https://a/$f$> $g$"), "$g$");
}

#[test]
fn elements_that_are_not_printed_are_not_read() {
    for name in ["template", "textarea", "title", "iframe", "noscript", "svg", "head", "xmp"] {
        assert_eq!(left(&format!("a\n<{name}>\n$f$\n\n$g$</{name}>\nb $h$")), "a b $h$", "{name}");
    }
    assert_eq!(left("<svg a=b><svg/><svg>$f$</svg> $g$</svg>$h$"), "$h$");
    assert_eq!(left("<div hidden><div>$f$</div>\n\n$g$</div>$h$"), "$h$");
    assert_eq!(left("<span style=\"color: red; display: none\">$f$</span>$h$"), "$h$");
    assert_eq!(left("<p hidden>\n\n$f$"), "", "one that is not closed");
    assert_eq!(left("<input hidden>$f$ <img hidden/>$g$"), "<input hidden>$f$ <img hidden/>$g$");
    assert_eq!(
        left("<details>\n<summary>$e$</summary>\n\n$f$\n\n</details>"),
        "<details> <summary>$e$</summary> $f$ </details>"
    );
    assert_eq!(left("<img alt=\"$f$\" title='$g$'/> $h$"), "$h$");
    assert_eq!(left("<a\n href=$f$>$g$</a>"), "$g$</a>");
    assert_eq!(left("a <b, $f$ > c"), "a <b, $f$ > c");
    assert_eq!(left("$a<b$ and $c>d$"), "$a<b$ and $c>d$");
    assert_eq!(left("<?php $f$ ?> <![CDATA[$g$]]> $h$"), "$h$");
}

#[test]
fn what_is_struck_out_or_commented_is_blank() {
    assert_eq!(left("~~$$f$$~~ $g$"), "$g$");
    assert_eq!(left("a ~~b\n$f$ c~~ $g$"), "a $g$");
    assert_eq!(left("a ~~ $f$ ~~ b"), "a ~~ $f$ ~~ b", "signs that touch nothing");
    assert_eq!(left("a~~$f$"), "a~~$f$");
    for name in ["del", "s", "strike"] {
        assert_eq!(left(&format!("<{name}>$f$</{name}> $g$")), "$g$", "{name}");
    }
    assert_eq!(left("<span>$f$</span>"), "<span>$f$</span>");
    for label in ["[//]: #", "[comment]: #", "[//]: <>"] {
        assert_eq!(left(&format!("{label} ($$f(x)=(a+b)$$)\n$g$")), "$g$", "{label}");
        assert_eq!(left(&format!("a\n{label} ($f(x)$\nmore)\n$g$")), "a $g$", "{label}");
    }
    assert_eq!(left("{% comment %}\n\n$$f$$\n{%- endcomment -%} $g$"), "$g$");
    assert_eq!(left("{% comment %} $f$"), "{ comment } $f$", "one that is not closed");
    assert_eq!(left("{% raw %}$f$"), "{ raw }$f$");
}

#[test]
fn formulas_behind_two_backslashes_and_in_scripts_are_read() {
    assert_eq!(left(r"a \\[f\\] \\(g % h\\) b"), r"a \[f \] \(g \) b");
    assert_eq!(left("a \\\\[f\n+g\\\\] b"), "a \\[f +g \\] b");
    assert_eq!(left(r"a \\[f b"), r"a \\[f b", "one that is not closed");
    assert_eq!(left(r"$a \\[2pt] b$"), r"$a \\[2pt] b$");
    assert_eq!(left("<script type=\"math/tex; mode=display\">f % x\n+g</script> a"), "$$f +g$$ a");
    assert_eq!(left("b <script type='math/tex'>f</script> a"), "b $f$ a");
    assert_eq!(left("<script>f</script> a"), "a");
}

#[test]
fn no_text_panics() {
    let text = "> - ```{é}\n:é:\n[é]: <é> (é)\n![é](é 'é') <é é=é> <a é=\"é\">{math}`é`\n-\té\n> ```math\né\n\n<svg>é</svg hidden>~~é~~{% comment %}é{% endcomment %}\\\\(é\\\\)<script type=math/tex>é</script>\n\n[//]: # (é)";
    for end in (0..=text.len()).filter(|i| text.is_char_boundary(*i)) {
        for start in (0..end).filter(|i| text.is_char_boundary(*i)) {
            left(&text[start..end]);
        }
    }
}
