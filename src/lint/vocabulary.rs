//! The vocabulary of [`super::words`]: words that take a formula back, one table for each way.
//!
//! **In:** nothing. **Out:** tables; semicolons part their words, and a space at an end belongs to the word: without it the word may go on.
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
    bogus; does not follow; no reason";

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
    condición; exig; find all; determined by; root of; touch; level set; this forces; which forces; tangen; \
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
    heuristic; formally; schematic; symbolic; in units; weakly; strongly; slowly; noncommut; non commut";

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
    work; simplif; einsetz";

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
