//! What a paper prints, and how it is read: every new reading with what is not read so.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use rederive::check::Limits;
use rederive::lint::{self, Word};
use rederive::paper::{self, Paper};

fn rederive(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder).env_remove("CLICOLOR_FORCE").args(arguments).assert()
}

fn read(tex: &str) -> Paper {
    let source = rederive::diag::Source { path: "paper.tex".into(), text: tex.into() };
    paper::parse(source, String::new()).unwrap_or_else(|d| panic!("{d}"))
}

/// The words on the relations of a paper, each with its reason.
fn said(tex: &str) -> Vec<(Word, String)> {
    let found = lint::lint(&read(tex), &Limits::default());
    found.judgements.into_iter().map(|j| (j.word, j.why)).collect()
}

/// The last word.
#[track_caller]
fn last(tex: &str) -> (Word, String) {
    said(tex).pop().expect("a relation")
}

#[test]
fn the_base_of_a_logarithm_is_said_by_an_option_or_a_configuration() {
    let folder = tempfile::tempdir().expect("a folder");
    let prove = |more: &[&str]| rederive(folder.path(), &[&["prove", r"\log x=\ln x", "--symbol", "x"], more].concat());
    prove(&[]).code(2).stderr(predicate::str::contains("--log natural"));
    prove(&["--log", "natural"]).code(0);
    prove(&["--log", "decimal"]).code(1);
    prove(&["--log", "binary"]).code(2);
    fs::write(folder.path().join("rederive.toml"), "log = \"natural\"\n").expect("written");
    prove(&[]).code(0);
    prove(&["--log", "decimal"]).code(1);
    fs::write(folder.path().join("page.tex"), r"\[ \log(ab)=\ln a+\ln b \]").expect("written");
    rederive(folder.path(), &["lint", "page.tex"]).code(0).stdout(predicate::str::contains("follows"));
    rederive(folder.path(), &["lint", "--log", "decimal", "page.tex"])
        .stdout(predicate::str::contains("follows").not());
    fs::write(folder.path().join("rederive.toml"), "log = \"binary\"\n").expect("written");
    rederive(folder.path(), &["lint", "page.tex"]).code(2).stderr(predicate::str::contains("rederive.toml:1:7"));
    fs::remove_file(folder.path().join("rederive.toml")).expect("removed");
    rederive(folder.path(), &["lint", "page.tex"]).code(0).stdout(predicate::str::contains("base of `\\log`"));
}

#[test]
fn a_box_of_text_is_no_formula() {
    let tex = r"\begin{align} a&=b+b & \makebox[3cm][l]{for all times,}\\ c&=2b & \eqmakebox[x][r]{or,} \end{align}";
    assert_eq!(said(tex).len(), 2, "{:?}", said(tex));
    let paper = read(tex);
    assert_eq!(paper.printed[0].remark.as_deref(), Some("for all times,"));
    // A box with a formula in it is none of text.
    assert_eq!(last(r"\[ A=\makebox[3cm]{$(a+b)^2$}=a^2+b^2 \]").0, Word::NotRead);
}

#[test]
fn words_in_the_place_of_a_last_side_are_left_out_and_named() {
    let (word, why) = last(r"\[ (a+b)^2=a^2+2ab+b^2=\text{area of the square} \]");
    assert!(word == Word::Follows && why.contains("“area of the square”"), "{word:?} {why}");
    // A unit, a name, and what is alone on the right are none.
    for tex in [r"\[ a=b=\text{max} \]", r"\[ a=b=5\text{ meters} \]", r"\[ s=\text{distance along the ray} \]"] {
        assert!(read(tex).printed[0].described.is_none(), "{tex}");
    }
    assert!(read(r"\[ a<b<\text{something larger} \]").printed[0].described.is_none());
}

#[test]
fn a_display_that_begins_with_a_sign_goes_on_from_the_one_before() {
    let tex = r"\[ A=(a+b)^2 \] \begin{equation}\label{x} =a^2+2ab+b^2. \end{equation}";
    assert_eq!(said(tex).iter().map(|s| s.0).collect::<Vec<_>>(), [Word::Defines, Word::Follows]);
    assert_eq!(last(r"\[ A=(a+b)^2 \] \[ =a^2-2ab+b^2 \]").0, Word::Wrong);
    // With anything between, or another file's, the side stays missing.
    for tex in [
        r"\[ A=(a+b)^2. \] \[ =a^2 \]",
        r"\[ A=(a+b)^2 \] and \[ =a^2 \]",
        r"\[ =a^2 \]",
        r"\[ A=(a+b)^2 \] $x=1$ \[ =a^2 \]",
    ] {
        assert_eq!(last(tex), (Word::NotRead, "a side that is missing".to_owned()), "{tex}");
    }
}

#[test]
fn an_index_that_is_free_on_the_left_is_summed_nowhere() {
    for tex in [
        r"\[ \frac{\partial c_i}{\partial T}=\frac{1}{P_{f,i}+1}\left(P_{f,i} a_i+b_i\right) \]",
        r"\[ k_{f,i}=A_iT^{\beta_i}E_i \]",
    ] {
        assert_ne!(last(tex).0, Word::NotRead, "{tex}: {:?}", last(tex));
    }
    for tex in [
        r"\[ \frac{\partial c_j}{\partial T}=P_i a_i \]",
        r"\[ \frac{\partial^2 c_i}{\partial T^2}=P_i a_i \]",
        r"\[ \frac{\partial c_i}{\partial x_i}=P_i a_i \]",
        r"\[ \frac{\partial c_i}{\partial T}+d=P_i a_i \]",
        r"\[ E=P_i a_i \]",
        r"\[ k_{f,j}=P_i a_i \]",
    ] {
        let (word, why) = last(tex);
        assert!(word == Word::NotRead && why.contains("index"), "{tex}: {word:?} {why}");
    }
}

#[test]
fn a_name_that_is_added_to_a_number_has_labels_below() {
    let of = |first: &str| last(&format!(r"\[ F={first} \] \[ Q=\frac{{P_{{r,i}}a_i}}{{b}}+P_{{r,i}} \]"));
    assert_eq!(of(r"\frac{c}{1+P_{r, i}}").0, Word::Defines, "{:?}", of(r"\frac{c}{1+P_{r, i}}"));
    // A sum with a name, or one that goes on, shows nothing of it.
    for first in [r"\frac{c}{q+P_{r,i}}", r"1+P_{r,i}a_i", r"\frac{c}{1+P_{r,i}a_i}", r"\frac{c}{1+P_{r,j}}"] {
        assert_eq!(of(first).0, Word::NotRead, "{first}: {:?}", of(first));
    }
}

#[test]
fn primes_print_the_same_however_they_are_written() {
    for primed in ["S''", r"S^{\prime\prime}", r"S^{''}", r"{S}''"] {
        let tex = format!(r"\[ A=({primed}_j-b)^2={primed}_j^2-2b{primed}_j+b^2 \]");
        let plain = tex.replace("_j", "");
        assert_eq!(last(&plain).0, last(r"\[ A=(S''-b)^2=S''^2-2bS''+b^2 \]").0, "{plain}: {:?}", last(&plain));
    }
    // What has more above it than primes is no prime.
    assert_ne!(read(r"\[ a=S^{\prime2} \]").printed[0].text(), read(r"\[ a=S' \]").printed[0].text());
}

#[test]
fn a_sign_of_derivatives_may_stand_in_a_label() {
    assert_eq!(last(r"\[ \Theta_{F_i,\partial T}=a+b \] \[ \Theta_{F_i,\partial T}^2=a^2+2ab+b^2 \]").0, Word::Follows);
    assert_ne!(
        last(r"\[ \Theta_{\partial T}=a \] \[ \Theta_{\partial V}=a^2 \] \[ \Theta_{\partial T}=\sqrt{a^2} \]").0,
        Word::Wrong
    );
}

#[test]
fn upright_words_are_read_where_they_are_a_transpose_or_a_function() {
    let matrix = r"\[ A=\begin{pmatrix}a&b\\0&d\end{pmatrix} \] ";
    assert_eq!(
        last(&format!(r"{matrix} \[ A^{{\text{{T}}}}=\begin{{pmatrix}}a&0\\b&d\end{{pmatrix}} \]")).0,
        Word::Follows
    );
    assert_eq!(last(r"\[ x=\text{exp}\left(a+b\right)=e^ae^b \]").0, Word::Follows);
    // Of a name of which nothing shows that it is a matrix it is anything; what is no function is words.
    assert_eq!(last(r"\[ Q^{\text{T}}R=RQ^{\text{T}} \]").0, Word::NotRead);
    assert_eq!(last(r"\[ x=\text{area}\left(a+b\right) \]").0, Word::NotRead);
}

#[test]
fn a_bold_name_with_a_hat_is_a_vector_and_refuted_by_nothing() {
    let (word, why) =
        last(r"\[ \mathbf{w}=(\hat{\mathbf{r}}+\mathbf{e})\times\hat{\mathbf{r}}=\mathbf{e}\times\hat{\mathbf{r}} \]");
    assert!(word == Word::Follows && why.contains("of any length"), "{word:?} {why}");
    // Its length is not any length, it may turn, it may be an operator.
    assert_ne!(last(r"\[ a=\hat{\mathbf{r}}\cdot\hat{\mathbf{r}}+b=1+b \]").0, Word::Wrong);
    assert_ne!(
        last(r"\[ \mathbf{v}=r\hat{\mathbf{r}} \] \[ \dot{\mathbf{v}}=\dot r\hat{\mathbf{r}} \]").0,
        Word::Follows
    );
    assert_eq!(
        last(r"\[ [\hat{\mathbf{x}},\hat{\mathbf{p}}]=i\hbar \] \[ \hat{\mathbf{p}}=m\mathbf{v} \]").0,
        Word::NotRead
    );
    assert_eq!(last(r"\[ \hat p\hat x=\hat x\hat p \]").0, Word::NotRead);
    // A vector may be called e, as well; and j a product of two of them.
    assert_eq!(
        last(r"\[ \mathbf{w}=(\mathbf{e}+\mathbf{a})\times\mathbf{a}=\mathbf{e}\times\mathbf{a} \]").0,
        Word::Follows
    );
    assert_eq!(
        last(r"\[ \mathbf{k}=\mathbf{e}_3e^{j\theta}=\mathbf{e}_3\cos\theta+\mathbf{e}_1\sin\theta \]").0,
        Word::NotRead
    );
}

/// Words for what ∇ does; not labels, and not what a paper calls so.
#[test]
fn upright_words_are_what_nabla_does() {
    let upright = |word: &str| {
        [
            format!(r"\operatorname{{{word}}}"),
            format!(r"\mathrm{{{word}}}\,"),
            format!(r"{{\rm {word}}}\,"),
            format!(r"\text{{{word}}} "),
        ]
    };
    for ((rot, div), grad) in upright("rot").iter().zip(upright("div")).zip(upright("grad")) {
        let text = format!(r"\[ q={div}({rot}\mathbf{{A}})=0 \]");
        assert_eq!(last(&text).0, Word::Follows, "{text}");
        let text = format!(r"\[ \mathbf{{w}}={rot}(f\mathbf{{E}})=f{rot}\mathbf{{E}}+({grad}f)\times\mathbf{{E}} \]");
        assert_eq!(last(&text).0, Word::Follows, "{text}");
        let text = format!(r"\[ \mathbf{{w}}={rot}(f\mathbf{{E}})=f{rot}\mathbf{{E}}-({grad}f)\times\mathbf{{E}} \]");
        assert_ne!(last(&text).0, Word::Follows, "{text}");
    }
    assert_ne!(last(r"\[ E_{\mathrm{rot}}=\frac12I\omega^2=\frac{L^2}{2I} \]").0, Word::Wrong);
    assert_eq!(last(r"\DeclareMathOperator{\rot}{rot}\[ q=\nabla\cdot(\rot\mathbf{A})=0 \]").0, Word::Follows);
}

#[test]
fn nabla_of_a_paper_without_coordinates_is_that_of_any_fields() {
    let (word, why) =
        last(r"\[ \mathbf{w}=\nabla\times(f\mathbf{E})=f\nabla\times\mathbf{E}+\nabla f\times\mathbf{E} \]");
    assert!(word == Word::Follows && why.contains("any fields"), "{word:?} {why}");
    assert_eq!(last(r"\[ q=\nabla\cdot(\nabla\times\mathbf{A})=0 \]").0, Word::Follows);
    // What is constant is not known: nothing is wrong, and what holds of constants alone does not follow.
    let of_constants = last(r"\[ \mathbf{w}=\nabla(cf)+\mathbf{a}=c\nabla f+\mathbf{a} \]").0;
    assert!(!matches!(of_constants, Word::Wrong | Word::Follows), "{of_constants:?}");
    // Along a path, or beside coordinates of its own, it stays unread.
    assert_eq!(last(r"\[ \frac{d}{ds}\left(n\frac{d\mathbf{r}}{ds}\right)=\nabla n \]").0, Word::NotRead);
}

#[test]
fn a_value_of_a_function_is_read_where_the_paper_shows_its_variable() {
    let tex = r"\[ y(x)=C\cos x+D\sin x \] \[ y(0)=C\cos 0+D\sin 0=C \]";
    assert_eq!(last(tex).0, Word::Follows, "{:?}", said(tex));
    assert_ne!(last(r"\[ x(t)=t \] \[ x'(0)=2 \]").0, Word::NotRead);
    // Of what is nowhere a function it is a product as well.
    for tex in [r"\[ k=2 \] \[ a=k(3) \]", r"\[ f=x+t \] \[ b=f(0)+1 \]"] {
        assert_eq!(last(tex).0, Word::NotRead, "{tex}: {:?}", said(tex));
    }
}

#[test]
fn a_prime_is_a_rate_where_the_paper_prints_a_place_behind_the_name() {
    let tex = r"\[ x(t)=\cos t \] \[ x'(t)=-\sin t \]";
    assert_eq!(last(tex).0, Word::Follows, "{:?}", said(tex));
    assert_ne!(last(r"\[ x'(t)=1 \] \[ x'=y \]").0, Word::NotRead);
    // Other axes have primes, too, two of them as well.
    for axes in [r"\[ x''=x'\cos\theta \]", r"\[ x'=x\cos\theta+y\sin\theta \]"] {
        let tex = format!(r"{axes} \[ x'^2=x^2 \]");
        assert_eq!(said(&tex)[1].0, said(&tex.replace("x''", "w").replace("x'", "u"))[1].0, "{tex}: {:?}", said(&tex));
    }
}

#[test]
fn a_frame_around_a_relation_is_layout() {
    for tex in [
        r"\[ \boxed{A=(a+b)^2=a^2+2ab+b^2} \]",
        r"\[ \fbox{$\displaystyle A=(a+b)^2=a^2+2ab+b^2$} \]",
        r"\begin{equation}\label{x} \tcboxmath[colback=white]{A=(a+b)^2=a^2+2ab+b^2}. \end{equation}",
        r"\[ \colorbox{red}{$A=(a+b)^2=a^2+2ab+b^2$}, \]",
        r"\[ \boxed{\begin{aligned} A&=(a+b)^2\\ &=a^2+2ab+b^2 \end{aligned}} \]",
        r"\begin{align} \Aboxed{A&=(a+b)^2=a^2+2ab+b^2} \end{align}",
        r"\[ A=(a+b)^2=\boxed{a^2+2ab+b^2} \]",
    ] {
        assert_eq!(said(tex).iter().map(|s| s.0).collect::<Vec<_>>(), [Word::Follows], "{tex}: {:?}", said(tex));
    }
    let two = r"\[ \boxed{a=b}\qquad\boxed{c=d} \]";
    assert_eq!(read(two).printed.iter().map(|r| r.sides.len()).collect::<Vec<_>>(), [2, 2]);
    // Two frames beside each other are no product.
    for tex in [r"\[ \boxed{a=b}\boxed{c=d} \]", r"\[ 2\boxed{a=b} \]", r"\[ \boxed{a=b}c \]"] {
        assert_eq!(last(tex).0, Word::NotRead, "{tex}: {:?}", said(tex));
    }
}

#[test]
fn a_sign_of_differences_ends_with_its_cell() {
    let tex = r"\[ M=\begin{pmatrix}\cos\delta & m\\ m & \cos\delta\end{pmatrix} \] \[ \delta=a+b \]";
    assert_eq!(said(tex).iter().map(|s| s.0).collect::<Vec<_>>(), [Word::Defines, Word::Defines], "{:?}", said(tex));
    assert_eq!(said(r"\[ M=a\delta m+b \] \[ \delta=a+b \]")[0].0, Word::NotRead);
}

/// What is read more generally than it is meant is refuted by points of which nothing was said.
#[test]
fn of_what_is_read_more_generally_nothing_is_wrong() {
    let of = |u: &str| last(&format!(r"\[ A=({u}+b)^2+c={u}^2-2b{u}+b^2+c \]")).0;
    assert_eq!(of("u"), Word::Wrong);
    for u in [r"(\hat{\mathbf{r}}\cdot\mathbf{a})", r"(\nabla\cdot\mathbf{a})"] {
        assert_eq!(of(u), Word::NotFollowed, "{u}");
    }
}

/// A prime derives by what stands behind the name, there or where it is defined, whatever stands behind it elsewhere in the paper.
#[test]
fn a_prime_derives_by_the_place_of_the_definition() {
    let elsewhere = r"\[ U(r)+U(r)^2=U(r)a \] \[ U(r)=b \] \[ U(r)>0 \] \section{B} \[ U(\theta)=mgr\cos\theta \]";
    for (step, word) in [
        (r"U'(\theta)=-mgr\sin\theta", Word::Follows),
        (r"U'=-mgr\sin\theta", Word::Follows),
        (r"U''(0)=-mgr", Word::Follows),
    ] {
        assert_eq!(last(&format!(r"{elsewhere} \[ {step} \]")).0, word, "{step}");
    }
    // What is said at another place is said for the first time.
    assert_eq!(last(&format!(r"{elsewhere} \[ U(0)=mgr\cos\theta \]")).1, "");
    assert_eq!(last(&format!(r"{elsewhere} \[ U(\theta)=mgr\cos\theta \]")).1, "as before");
    // The derivatives by r.
    for step in [r"U'(\theta)=mg\cos\theta", r"U'=mg\cos\theta", "U''(0)=0", r"U(0)=mgr\cos\theta"] {
        let found = last(&format!(r"{elsewhere} \[ {step} \]"));
        assert_ne!(found.0, Word::Follows, "{step}: {found:?}");
    }
}

#[test]
fn a_function_of_several_variables_is_what_the_paper_defines() {
    let wave = r"\[ w(z,t)=(z-ct)^2 \]";
    let of = |step: &str| last(&format!(r"{wave} \[ {step} \]")).0;
    assert_eq!(of(r"\frac{\partial w}{\partial t}=-2c(z-ct)"), Word::Follows);
    assert_eq!(of(r"\frac{\partial w}{\partial t}=-c\frac{\partial w}{\partial z}"), Word::Follows);
    assert_eq!(of(r"\frac{\partial w}{\partial t}=2c(z-ct)"), Word::Wrong);
    // At other places it is another value, and along a motion z has a rate of its own.
    for more in [r"\[ w(0,t)=1 \]", r"\[ w(t,z)=a \]", r"\[ \frac{dw}{dt}=a \]", r"\[ \dot w=a \]"] {
        for step in [r"\frac{\partial w}{\partial t}=-2c(z-ct)", r"\frac{\partial w}{\partial t}=2c(z-ct)"] {
            let word = last(&format!(r"{wave} {more} \[ {step} \]")).0;
            assert!(!matches!(word, Word::Follows | Word::Wrong), "{more} {step}: {word:?}");
        }
    }
}

#[test]
fn a_rate_over_a_slash_is_one() {
    let of = |step: &str| last(&format!(r"\[ y=x^3 \] \[ {step} \]"));
    for step in ["dy/dx=3x^2", r"\mathrm{d}y/\mathrm{d}x=3x^2", r"{dy\over dx}=3x^2"] {
        assert_eq!(of(step).0, Word::Follows, "{step}: {:?}", of(step));
    }
    assert_eq!(of("dy/dx=2x^2").0, Word::Wrong);
    // One differential alone, and a d that divides another.
    for step in ["dy=3x^2dx", "dy/x=3x", "y/dx=3", "dy-dx=0"] {
        assert_eq!(of(step).0, Word::NotRead, "{step}");
    }
}

#[test]
fn rows_of_plain_tex_are_rows() {
    for rows in [
        r"$$ \eqalign{ (a+b)^2 &= a^2+2ab+b^2 \cr (a-b)^2 &= a^2-2ab+b^2 \cr} $$",
        r"$$ \displaylines{ (a+b)^2 = a^2+2ab+b^2 \cr (a-b)^2 = a^2-2ab+b^2 \cr} $$",
        r"$$ \eqalignno{ (a+b)^2 &= a^2+2ab+b^2 &(1)\cr (a-b)^2 &= a^2-2ab+b^2 &(2)\cr} $$",
    ] {
        let found: Vec<Word> = said(rows).into_iter().map(|s| s.0).filter(|w| *w != Word::NotRead).collect();
        assert_eq!(found, [Word::Follows, Word::Follows], "{rows}: {:?}", said(rows));
    }
    let slip = r"$$ \eqalign{ (a+b)^2 &= a^2+2ab+b^2 \cr (a-b)^2 &= a^2-2ab-b^2 \cr} $$";
    assert_eq!(last(slip).0, Word::Wrong);
}

#[test]
fn of_two_names_before_one_sign_nothing_is_said() {
    let tex = r"\[ r_1, r_2 = -p\pm q \] \[ r_2-r_1=0 \] \[ r_2=-p+q \]";
    let found = said(tex);
    assert_eq!(found[0], (Word::NotRead, "a list".to_owned()), "{found:?}");
    assert!(found[1..].iter().all(|s| !matches!(s.0, Word::Follows | Word::Wrong)), "{found:?}");
}

#[test]
fn a_letter_that_is_summed_over_is_no_label() {
    let labels = r"\[ p_\theta=m_\theta v \] \[ R=p_\theta q_\theta+p_f q_f-m_g \]";
    let step = r"\[ p_i q_i-L=R+p_i q_i-L-R \]";
    assert_eq!(last(&format!("{labels} {step}")).0, Word::Follows);
    // Beside an index it is one.
    let beside = format!(r"{labels} \[ \sigma_i p_i-L=R+\sigma_i p_i-L-R \]");
    assert_eq!(last(&beside), (Word::NotRead, "an index that may be summed over, i".to_owned()));
    let summed = format!(r"{labels} \[ R=\sum_{{i=1}}^n m_i \] {step}");
    assert_eq!(last(&summed), (Word::NotRead, "an index that may be summed over, i".to_owned()));
}

/// `\Delta_rH` is a name with a label, and says nothing of the sign: `\Delta H` beside it is a difference.
#[test]
fn a_label_of_a_difference_leaves_others_names() {
    let of = |first: &str| last(&format!(r"\[ {first} \] \[ \Delta H=2q \]")).0;
    assert_ne!(of(r"g=\Delta_r H"), Word::NotRead);
    assert_eq!(of(r"g=\Delta^2 H"), Word::NotRead);
}
