//! Commands that LaTeX and amsmath have, whatever a document defines: `\providecommand` leaves them as they are.
//!
//! **In:** a name. **Out:** whether it is one of these. **Guaranteed:** names that papers give commands of their own are not among them.

use std::collections::BTreeSet;
use std::sync::LazyLock;

/// Letters, functions, signs, accents, fractions and styles.
const COMMANDS: &str = "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi pi varpi rho varrho sigma \
     varsigma tau upsilon phi varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega \
     hbar imath jmath ell wp Re Im aleph partial infty prime nabla emptyset surd top bot angle forall exists neg \
     arccos arcsin arctan arg cos cosh cot coth csc deg det dim exp gcd hom inf ker lg lim liminf limsup ln log max min Pr sec sin sinh \
     sup tan tanh sum prod coprod int oint bigcap bigcup bigoplus bigotimes pm mp times div ast star circ bullet cdot cap cup vee wedge \
     oplus ominus otimes oslash odot dagger ddagger le leq ge geq ne neq equiv sim simeq approx cong propto ll gg prec succ subset supset \
     in ni notin mid parallel perp to rightarrow leftarrow Rightarrow Leftarrow leftrightarrow Leftrightarrow mapsto \
     hat check breve acute grave tilde bar vec dot ddot widehat widetilde overline underline overbrace underbrace overrightarrow \
     frac dfrac tfrac cfrac binom sqrt stackrel overset underset left right big Big bigg Bigg langle rangle lfloor rfloor lceil rceil \
     mathrm mathbf mathit mathsf mathtt mathcal boldsymbol text textrm textbf textit mbox ensuremath operatorname \
     quad qquad ldots cdots vdots ddots dots label ref eqref tag begin end section chapter \
     b c d H k l L o O r t u v i j P S a A AE ae aa AA ss";

static NAMES: LazyLock<BTreeSet<&'static str>> = LazyLock::new(|| COMMANDS.split_whitespace().collect());

/// Whether LaTeX has this command.
pub(super) fn is_of_latex(name: &str) -> bool {
    NAMES.contains(name)
}
