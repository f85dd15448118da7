//! The vocabulary of [`super::words`] and [`super::sentence`]: words that take a formula back, conclude, loosen or solve, one table for each way.
//!
//! **In:** nothing. **Out:** tables; in a text semicolons part the words, and a space at an end belongs to the word: without it the word may go on.
//! **Guaranteed:** small letters and single spaces, as in the texts in which they are looked for.

/// Words that deny: of others, of an older version, or outright.
pub(super) const DENY: &str = "\
    instead of; rather than; contrary; contradict; unlike; as opposed; cannot; can not ; can't; impossib; untrue; \
    not true; is false; are false; false ; wrong; incorrect; erroneous; mistak; fallac; absurd; nonsense; \
    no longer; never; neither; violat; fails; fail ; failed; breaks down; break down; not hold; not valid; \
    not equal; not the case; not in general; not satisf; nobody; no one ; few believe; there is no ; there are no ; \
    there isn't; would; student; beginner; author; claim; believ; it is said; they write; people write; \
    often written; sometimes written; erratum; errata; corrig; misprint; typo ; typos; typographical; should read; \
    should be; should have; version; used to read; used to be; anstatt; statt ; behaupte; gilt nicht; gelten nicht; \
    fehler; falsch; niemand; wäre; au lieu; erreur; faux; n'est pas; prétend; invece di; errore; falso; nessuno; \
    en lugar; en vez; nadie; should it; were it; draft; careless; textbook; unfortunately; was thought; \
    long thought; often see; often find; will object; assert; wrongly; according to; remains to be; whether; doubt; refut; disprov; \
    per assurdo; absurdum; avoid; beware; inconsisten; ruled out; reject; invalid; forbidden; unphysical; unjustif; \
    illegal; illegitim; too good; alleged; purport; allegedly; sloppy; counterexample; counter example; spurious; \
    bogus; does not follow; no reason; trap ; traps ; pitfall; flaw; bug ; bugs ; hardly; nothing like; without the ; \
    in place of; lack ; lacks ; differs from; differ from; confus; disproof; disprove; reason against; misconception; myth; \
    answered; in exams; edition; printing; homework; oops; off ; corrupt; blunder; negative example; produced by; contained; killed; common error; schüler; schwindel; élève; alumno; fallo; sbaglio; printed by; we correct; corrects the";

/// Words that suppose, or pose what is to be solved or demanded.
pub(super) const SUPPOSE: &str = "\
    suppos; assum; presum; hypothe; conject; ansatz; postulat; imagin; pretend; might; perhaps; tempt; naiv; guess; \
    we expect; one expects; we hope; we want; we wish; trial; seek; look for; looking for; search for; \
    searching for; such that; there exist; for some ; were true; were the case; were to hold; it were; criterion; \
    criteria; constrain; require; demand; impose; imposing; enforc; must ; equality of; be equal; are equal; \
    set equal; set both; both equal; equal to each other; equate ; equates; equating; equated; balanc; equilib; \
    stationar; vanish; resonan; satisf; obey; fulfil; is solved; are solved; solutions; coincid; intersect; meet ; \
    meets ; crosses; cross at; cross where; cross when; cross if; they cross; two cross; curves cross; lines cross; \
    cross each; equidistant; same distance; equal distance; locus; loci; curve; the set of; \
    the points; points ; point where; points where; unless; provided; \
    as long as; in case ; only if; only when; only for; only where; only at; only in; holds for; hold for; \
    holds in; holds on; holds at; holds only; holds if; holds when; for which; at which; where both; angenommen; \
    annahme; nehmen wir an; bedingung; fordern; verlang; gleichgewicht; erfüll; gesucht; supposons; hypoth; \
    condizione; équilibre; exige; satisf; supponiamo; ipotesi; equilibrio; richied; imponiamo; supongamos; \
    condición; exig; find all; find every; show that no; tick ; determined by; root of; touch; level set; this forces; which forces; tangen; \
    degenera; occurs at; occurs when; occurs where; occurs if; happens when; happens if; to be solved; \
    is equivalent to; let us take; say that; merge; zero set; contour; turning point; \
    on shell; matching";

/// Words that make a formula inexact, or say that its letters are no numbers, or that another one is meant with something changed.
pub(super) const LOOSEN: &str = "\
    up to ; roughly; nearly; almost; small; tiny; negligib; weak; modulo; mod ; limit; leading; lowest; estimat; \
    crude; in the mean; expectation; rounded; far away; far from; grassmann; anticommut; anti commut; commut; \
    clifford; quaternion; nilpotent; idempotent; fermion; orthogonal; orthonormal; perpendicular; right angle; \
    uncorrelated; incoheren; disjoint; boolean; characteristic; tropical; replac; interchang; exchang; swap; \
    opposite sign; other sign; sign flip; bis auf; näherung; senkrecht; ordnung; ersetz; petit; à l'ordre; ordre; \
    remplaç; piccol; ordine; sostitu; pequeñ; orden; regime; averag; are independent; statistically; mutually; \
    negative definite; sending; parity; a reflection; reflecting; time reversal; truncat; coarse; on average; perturb; \
    heuristic; formally; schematic; symbolic; in units; weakly; strongly; slowly; noncommut; non commut; random; retain; \
    keeping only; keep only; integrating over; averaging over; contribut; throw; surface term; boundary term; mean zero; zero mean; perp ; \
    two elements; mod p; reversed; reversing; backward; mirror; flip; turned over; opposite naming; in quadrature; odd variable; exterior algebra; be sets; are sets; primes denot; prime denot";

/// Words that restrict what stands before them, right behind a formula.
pub(super) const RESTRICT: &str = "\
    near ; along; inside; outside; within ; on ; at ; wenn ; falls ; nur ; auf ; quand ; lorsqu; quando ; cuando ";

/// Words behind a formula with which it is the subject of a sentence, that says what it is.
pub(super) const SUBJECT: &str = "\
    is a ; is an ; is the equation; is the condition; is one ; is what; is not; are the ; describes; represents; \
    defines; determines; has ; holds ; can be ; could ; may ; does not; doesn't; implies; means ; forces; not ; \
    ist ein; est un; è un; es un; ist nicht; non ; no es; is equivalent; is inconsistent; is ruled; is to be; \
    is wrong; is only; is unphysical; is needed; is required; is assumed; is imposed";

/// Words that open a case; behind the last of them the case may be one of reckoning, "if we square".
pub(super) const IFS: &str = "\
    if; iff; when; whenever; wenn; falls; sofern; quand; lorsque; quando; cuando";

/// What somebody does who reckons: no case.
pub(super) const ACTS: &str = "\
    insert; substitut; plug; put ; square; expand; multipl; divid; add; subtract; different; deriv; integrat; use ; \
    apply; rewrite; write; rearrang; solve; combin; factor; collect; compare; now ; look; sum ; comput; calculat; \
    work; simplif; complet; cancel; einsetz";

/// Words that conclude from the formula before them.
pub(super) const CONCLUDE: &str = "\
    so ; hence; thus; then ; therefore; gives ; yields; implies; it follows; we get; we obtain; we find; we have; \
    also ; daraus; donc; quindi; luego";

/// Words that begin a sentence about a place.
pub(super) const PLACES: &str = "\
    on; at; along; near; inside; outside; within; auf; bei; sur; sul; sulla; where";

/// Words behind them, of what is none.
pub(super) const NO_PLACES: &str = "\
    hand; side; contrary; first; last; same; other; end; one; stage; time; left; right; this point; top; basis";

/// Words that link a sentence to the one before it.
pub(super) const LINKING: &str = "\
    this ; that ; it ; these ; but ; of course; clearly; which ; dies ; das ; cela ; ceci ; questo ; esto ";

/// Abbreviations, the full stop behind which ends no sentence.
pub(super) const ABBREVIATED: &str = "\
    eq; eqs; fig; figs; ref; refs; sec; e.g; i.e; cf; eqn; eqns; vs; prop; thm; resp; z.b; d.h";

/// Words that restrict what stands before them, also some way behind a formula.
pub(super) const RESTRICT_ANYWHERE: &str = "\
    if ; iff ; when ; whenever; unless; provided; assuming; as long; only; except; modulo; mod ";

/// Sets of points, and equations, that are the last word before the formula that poses them.
pub(super) const POSED: &str = "\
    line; lines; plane; planes; surface; surfaces; circle; circles; sphere; curve; curves; point; points; set; region; ellipse; \
    hyperbola; parabola; cone; cylinder; equation; equations; relation; constraint";

/// Words for what one does with an equation, right before it: "Solve", but not "Solving, we get".
pub(super) const POSING: &str = "\
    solve; solves; solving; consider; considering; given; graph; plot; sketch; draw; study; löse; lösen; betrachte; betrachten; gegeben; résoudre; \
    résolvez; considérons; risolvere; risolvi; consideriamo; resolver; resuelve; consideremos";

/// Words behind which a display stands that says something: what its sentence does is known by its last word.
pub(super) const ASSERTING: &str = "\
    is; are; was; be; reads; read; becomes; become; gives; give; yields; yield; have; has; get; gets; obtain; obtains; find; finds; \
    see; know; knows; as; to; namely; equals; by; follows; follow; hence; so; then; thus; therefore; and; also; where; with; which; \
    it; implies; imply; means; shows; show; note; recall; ie; or; equivalently; consequently; accordingly; finally; ist; sind; lautet; \
    lauten; ergibt; folgt; gilt; gelten; also; somit; daher; haben; hat; erhalten; erhält; finden; und; est; sont; donne; a; obtient; donc; \
    alors; et; ainsi; è; sono; ha; abbiamo; quindi; e; es; son; tenemos; luego; y; now; here; again; explicitly; simplifies; simplify; \
    expanding; simplifying; rearranging; substituting; squaring; differentiating; dividing; multiplying; adding; subtracting; combining; \
    compute; computes; calculate; write; writes; takes; form; check; verify";

/// What may be said with the words before: "the identity", after "we use".
pub(super) const ASSERTED: &str = "\
    identity; identities; formula; formulas; formulae; relation; relations; equation; equations; law; rule; theorem; result; results; \
    expression; expansion; solution; following; formel; gleichung; identität; beziehung; équation; formule; relation; identité; equazione; \
    formula; ecuación; fórmula; value; energy; momentum; derivative; product; sum; square; determinant; integral; matrix";

/// Words between those and what uses them.
pub(super) const OF_THESE: &str = "\
    the; this; a; an; following; simple; well; known; trigonometric; usual; standard; exact; general; important; useful; algebraic; our; its; \
    elementary; basic; familiar; die; der; das; folgende; bekannte; la; le; l; suivante; los; el; il; lo; their; his; resulting; desired; same";

/// What uses an identity, or leads to it.
pub(super) const USES: &str = "\
    use; using; uses; used; have; has; recall; by; from; obtain; get; to; is; note; via; through; with; and; need; apply; applying; find; yields; \
    gives; consider; derive; derives; prove; proves; in; of; mit; aus; durch; avec; par; con; per; satisfy; satisfies; obey; obeys; that; so; then; \
    hence; thus; therefore";

/// Words before "that" behind which something is said.
pub(super) const SAYS_THAT: &str = "\
    see; find; know; shows; show; showed; note; notice; follows; follow; have; has; means; implies; imply; recall; so; such; verify; check; conclude; \
    observe; deduce; seen; shown; known; found; remember; obtain; get; clear; obvious; easily; sehen; folgt; finden; wissen; gilt; voit; sait; trouve; \
    déduit; vede; segue; trova; sigue; ve; fact; now; assures; guarantees; says; states; tells us; us";

/// Words for several things, or for another one than before.
pub(super) const SEVERAL: &str = "\
    two ; three ; four ; pair ; twice the ; twice as ; double; doubling; triple; half the ; halv; second ; third ; excited; in parallel; in series; another; other ; \
    each ; zwei ; drei ; doppelt; halbe ; zweite; andere; deux ; double; moitié; autre; due ; doppi; metà; altro; dos ; doble; mitad; otro; \
    without ; instead ; times as ; times the ; new ";

/// Words behind them where they count parts of a formula.
pub(super) const OF_FORMULAS: &str = "\
    side; equation; term; order; derivative; rate; ableitung; dérivée; law; factor; expression; formula; hand; identit; line; step; way; relation; result; row; column; \
    sum; integral; part; condition; root; solution; , ";

/// Words with which a sentence begins that gives a reason, goes on, or says what is done.
pub(super) const REASONS: &str = "\
    we; since; because; as; on; in; from; by; for; using; with; if; when; after; then; thus; hence; therefore; so; and; now; finally; first; next; where; \
    which; here; again; also; consequently; let; da; weil; aus; mit; nach; dann; also; wir; comme; puisque; nous; on; donc; poiché; dato; noi; como; \
    dado";

/// Words with which a sentence begins that goes on with what was spoken of.
pub(super) const GOES_ON: &str = "\
    we; since; because; as; by; from; using; then; thus; hence; therefore; so; and; finally; which; it; this; that; its; consequently; where; one; for; \
    if; when; let; also; here; obviously; clearly; indeed; explicitly; equivalently; da; weil; aus; daraus; also; somit; daher; dann; wir; man; es; \
    dies; sein; seine; ihre; comme; puisque; nous; on; donc; ainsi; son; sa; quindi; allora; poiché; luego; entonces; su; upon; after; to; in order; \
    next; now; with; in; writing; again; moreover; furthermore; accordingly; however; but; note; recall; they; their; these; those; is; are; gives; \
    yields; where; on ; of";

/// Words that reckon and conclude, and those between them.
pub(super) const RECKONING: &str = "\
    so; hence; thus; therefore; then; this; that; these; them; which; it; we; us; one; the; above; last; again; and; by; with; to; from; for; of; on; in; into; as; is; are; be; \
    can; get; obtain; find; have; see; gives; give; implies; imply; yields; yield; follows; leads; becomes; reads; solving; solve; solved; \
    simplifying; simplifies; simplify; rearranging; rearrange; dividing; divide; multiplying; multiply; subtracting; adding; collecting; expanding; \
    substituting; substitute; inserting; insert; plugging; plug; using; eliminating; eliminate; squaring; differentiating; integrating; cancelling; \
    canceling; taking; combining; both; sides; side; left; right; hand; equation; equations; relation; relations; expression; result; solution; root; \
    value; written; rewritten; rewrite; write; form; immediately; easily; directly; clearly; obviously; explicitly; namely; finally; also; \
    consequently; accordingly; equivalently; where; through; out; back; daraus; folgt; also; somit; damit; ergibt; erhalten; wir; man; und; nach; \
    einsetzen; auflösen; liefert; donc; on; obtient; ainsi; quindi; luego";

/// What comes of a quantity by reckoning, and its names.
pub(super) const OPERATIONS: &str = "\
    derivative; rate; rates; velocity; speed; acceleration; slope; gradient; square; root; product; sum; difference; ratio; quotient; inverse; \
    reciprocal; result; solution; equation; expression; formula; left; right; integral; logarithm; exponential; first; determinant; identity; \
    relation; expansion; ableitung; geschwindigkeit; beschleunigung; quadrat; dérivée; vitesse; derivata; velocità; derivada; velocidad; \
    chain; rule; definition; motion; second; force; energy; momentum";

/// Words with which a sentence concludes from the formula before it.
pub(super) const CONCLUDES: &[&str] = &[
    "hence",
    "then",
    "thus",
    "therefore",
    "consequently",
    "accordingly",
    "it follows",
    "so that",
    "which gives",
    "which implies",
    "this gives",
    "this implies",
    "gives",
    "yields",
    "implies",
    "we get",
    "we obtain",
    "we find",
    "we have",
    "leads to",
    "or equivalently",
    "equivalently",
    "that is",
    "i.e.",
    "simplifies",
    "reduces to",
    "solving",
    "rearranging",
    "so ",
    "⇒",
];

/// Words of a sentence whose equations need not be exact, or whose constants may change from line to line.
pub(super) const LOOSENS: &[&str] = &[
    "approx",
    "neglect",
    "leading order",
    "to first order",
    "at first order",
    "first order in",
    "to second order",
    "second order in",
    "lowest order",
    "higher order",
    "higher-order",
    "zeroth order",
    "to order",
    "linear order",
    "ignor",
    "dropping",
    "drop the",
    "we drop",
    "discard",
    "omit",
    "linearis",
    "lineariz",
    "expansion",
    "taylor",
    "asymptotic",
    "in the limit",
    "for small",
    "for large",
    "is small",
    "is large",
    "are small",
    "are large",
    "small compared",
    "large compared",
    "sufficiently small",
    "sufficiently large",
    "roughly",
    "absorb",
    "redefin",
    "re-defin",
    "rescal",
    "renam",
    "relabel",
    "natural units",
    "choose units",
    "choice of units",
    "set of units",
    "system of units",
    "units in which",
    "units where",
    "units such that",
    "nondimension",
    "non-dimension",
    "dimensionless",
    "up to a",
    "up to an",
    "modulo",
    "of integration",
    "integration constant",
    "arbitrary constant",
    "on average",
    "averages out",
    "orthogonal",
    "perpendicular",
    "incoherent",
    "uncorrelated",
    "pythagor",
    "mistake",
    "incorrect",
    "erroneous",
    "wrong",
    "contradict",
    "suppose instead",
    "if instead",
    "would have",
    "would be",
    "not equal",
];

/// Words of a sentence that says what is to be shown.
pub(super) const AIMS: &[&str] = &[
    "want to show",
    "wish to show",
    "to show that",
    "to prove",
    "must show",
    "show that:",
    "prove that",
    "zu zeigen",
    "montrons",
    "montrer que",
    "dimostriamo",
    "dimostrare che",
    "mostrar que",
    "demostrar",
];

/// Words of a sentence whose equation is to be solved.
pub(super) const SOLVES: &[&str] = &[
    "to solve",
    "must solve",
    "we solve",
    "solve the",
    "solve for",
    "solutions to",
    "solutions of",
    "solution to",
    "solution of",
    "satisf",
    "intersect",
    "find the",
    "set equal",
    "root of",
    "roots of",
    "equate",
    "inner product",
    "scalar product",
    "inner form",
    "prodotto scalare",
    "produit scalaire",
    "producto escalar",
    "produto escalar",
    "skalarprodukt",
];

/// Words of a sentence that gives a name another meaning, or another case.
pub(super) const CHANGES: &[&str] = &[
    "now",
    "instead",
    "becomes",
    "case",
    "if",
    "when",
    "for",
    "let",
    "choose",
    "another",
    "different",
    "new",
    "modified",
    "corrected",
    "next",
    "third",
    "second",
    "other",
    "replace",
    "replaced",
    "alternatively",
    "respectively",
    "without",
    "at",
    "while",
    "whereas",
    "or",
];

/// Words that do so behind the last formula of a sentence; before it they only link: "resistors in parallel obey $\ldots$, so that".
pub(super) const LINKS: &[&str] = &["generally", "general", "with", "in", "but"];

/// Words with which a formula behind a display says what its names stand for.
pub(super) const WHERE: &[&str] = &["where", "with", "here", "in which", "wherein"];
