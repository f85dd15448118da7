//! The cases that a text treats one after the other, and what it takes back or asks.
//!
//! **In:** the text of a file. **Out:** whether what is said at one place may be of another case than what stands at a later one; whether the
//! words around a formula deny it, or ask for it. **Guaranteed:** words only keep something from being used, or from being judged.

use diag::next_character;

use super::signs::places_of;

/// How a word at the beginning of a sentence parts cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Opener {
    /// Another case may begin.
    Opens,
    /// It says of what follows in its sentence that it is a case.
    Case,
    /// The same, of a case that ends with the sentence.
    Moment,
}

/// Words that begin a sentence about a case.
const OPENERS: &[(&str, Opener)] = &[
    ("For", Opener::Case),
    ("If", Opener::Moment),
    ("When", Opener::Moment),
    ("At", Opener::Moment),
    ("Suppose", Opener::Case),
    ("Case", Opener::Case),
    ("Consider", Opener::Opens),
    ("Considering", Opener::Opens),
    ("Assume", Opener::Case),
    ("Near", Opener::Moment),
    ("In", Opener::Opens),
    ("On", Opener::Opens),
    ("Now", Opener::Opens),
    ("Alternatively", Opener::Opens),
    ("Instead", Opener::Opens),
    ("Otherwise", Opener::Opens),
    ("Similarly", Opener::Opens),
    ("Likewise", Opener::Opens),
    ("Finally", Opener::Opens),
    ("Next", Opener::Opens),
    ("Without", Opener::Opens),
    ("With", Opener::Opens),
    ("Initially", Opener::Moment),
    ("Unless", Opener::Moment),
    ("After", Opener::Opens),
    ("Before", Opener::Opens),
    ("Für", Opener::Case),
    ("F\\\"ur", Opener::Case),
    ("Falls", Opener::Moment),
    ("Wenn", Opener::Moment),
    ("Bei", Opener::Moment),
    ("Im", Opener::Opens),
    ("Jetzt", Opener::Opens),
    ("Nun", Opener::Opens),
    ("Pour", Opener::Case),
    ("Si", Opener::Moment),
    ("Quand", Opener::Moment),
    ("Lorsque", Opener::Moment),
    ("Dans", Opener::Opens),
    ("Au", Opener::Opens),
    ("Per", Opener::Case),
    ("Se", Opener::Moment),
    ("Quando", Opener::Moment),
    ("Nel", Opener::Opens),
    ("Para", Opener::Case),
    ("Cuando", Opener::Moment),
    ("En", Opener::Opens),
    ("No", Opener::Opens),
    ("Problem", Opener::Opens),
    ("Exercise", Opener::Opens),
    ("Question", Opener::Opens),
    ("Aufgabe", Opener::Opens),
    ("Exercice", Opener::Opens),
    ("Esercizio", Opener::Opens),
    ("Ejercicio", Opener::Opens),
    ("Part", Opener::Opens),
    ("Disc", Opener::Opens),
    ("Ring", Opener::Opens),
];
/// Commands behind which another thing may begin.
const BREAKS: &[&str] = &[
    r"\textbf{",
    r"\intertext{",
    r"\question",
    r"\begin{frame",
    r"\newpage",
    r"\clearpage",
    r"\paragraph",
    r"\subparagraph",
    r"\problem",
    r"\exercise",
    r"\part",
    r"\begin{aufgabe",
    r"\begin{exercice",
    r"\begin{esercizio",
    r"\begin{ejercicio",
    r"\begin{question",
    r"\begin{problem",
    r"\begin{Aufgabe",
];

/// Words with which a sentence sets itself against what was said before it.
const CONTRASTS: &[&str] = &[
    "however",
    "instead",
    "otherwise",
    "conversely",
    "by contrast",
    "in contrast",
    "on the other hand",
    "opposite case",
    "inverse case",
    "reverse case",
    "other way round",
    "vice versa",
    "umgekehrt",
    "caso inverso",
    "caso opposto",
    "caso contrario",
    "cas inverse",
    "cas contraire",
    "dagegen",
    "hingegen",
    "andernfalls",
    "invece",
    "viceversa",
    "en revanche",
    "au contraire",
    "sinon",
    "en cambio",
    "por el contrario",
];

/// Words for one of two kinds of a thing.
const PAIRS: &[[&str; 2]] = &[
    ["left", "right"],
    ["upper", "lower"],
    ["inner", "outer"],
    ["inside", "outside"],
    ["positive", "negative"],
    ["odd", "even"],
];
/// Things of two kinds, right behind such a word.
const THINGS: &[&str] =
    &["branch", "side ", "half", "part ", "region", "well", "lobe", "sheet", "root", "solution", "case"];
/// Sides of an equation, which are no thing of two kinds.
const NO_THINGS: &[&str] =
    &["hand", "side of (", r"side of \", "side of eq", "side of the eq", "side is", "side becomes"];
/// So far behind such words a formula is still about that kind.
const KIND: usize = 300;
/// Abbreviations, the full stop behind which ends no sentence.
const ABBREVIATED: &[&str] =
    &["Thm", "Eq", "Eqs", "Fig", "Sec", "Prop", "Def", "Cor", "Ex", "cf", "e.g", "i.e", "resp", "vs"];

/// Whether a word stands before a thing of which there are two kinds.
fn names_a_kind(text: &str, at: usize, word: &str) -> bool {
    let behind = at + word.len();
    let behind = &text[behind..next_character(text, behind + 24)];
    let plain = behind.trim_start_matches(['\'', '`', '-', ' ', '~']);
    let starts = |all: &[&str]| all.iter().any(|w| plain.starts_with(w));
    let before = text[..at].chars().next_back();
    !before.is_some_and(|c| c.is_alphanumeric() || c == '\\') && starts(THINGS) && !starts(NO_THINGS)
}

/// The longest text of a sentence that is looked at before a formula, and behind it.
const BEFORE: usize = 160;
const BEHIND: usize = 100;

/// Words with which a sentence denies its formula.
const DENIES: &[&str] = &[
    "not true",
    "untrue",
    "is false",
    "are false",
    "incorrect",
    "(wrong",
    "wrong!",
    "is wrong",
    "are wrong",
    "not hold",
    "n't hold",
    "not have",
    "not the case",
    "not correct",
    "not in general",
    "not equal",
    "not valid",
    "never holds",
    "mistake",
    "erroneous",
    "fallacy",
    "es cierto que",
    "n'est pas vra",
    "non è vero",
    "non \\`e vero",
    "fehler",
    "erreur",
    "errore",
    "the error:",
    "one might think",
    "man könnte meinen",
    "true or false",
    "vrai ou faux",
    "richtig oder falsch",
    "falsche l",
    "which holds",
    "a beginner",
    "unlike",
    "we forget",
    "characteristic",
    r"\mathbb f",
    "contradiction",
    "gilt nicht",
    "non vale",
    "no se cumple",
    "n'a pas",
    "not imply",
    "would be wrong",
    "fails",
    "not an identity",
    "is impossible",
    "not satisfied",
    "cannot hold",
    "spot all",
    "spot the",
    "find the error",
    "find all errors",
    "student differentiates",
    "a student claims",
];

/// Commands whose argument is a choice of a question.
const CHOICES: &[&str] = &[r"\choice", r"\wrongchoice", r"\correctchoice", r"\CorrectChoice", r"\task", r"\answer"];

/// Where the cases of a text begin.
#[derive(Clone, Debug, Default)]
pub struct Cases {
    /// Sentences that begin with a word of [`OPENERS`].
    openers: Vec<(usize, &'static str, Opener)>,
    /// Where items of lists begin, and where lists end.
    items: Vec<(usize, bool)>,
    /// Where sentences and paragraphs end.
    stops: Vec<usize>,
    /// Where another thing may begin.
    breaks: Vec<usize>,
    /// Where a sentence sets itself against another.
    contrasts: Vec<usize>,
    /// Where one of two kinds is named, "the left branch": the number of the pair, and which of the two.
    kinds: Vec<(usize, usize, usize)>,
}

impl Cases {
    /// Finds the cases of a text.
    pub fn of(text: &str) -> Cases {
        let mut out = Cases::default();
        for &(word, opener) in OPENERS {
            let is_word = |at: usize| {
                let before = text[..at].chars().next_back();
                let behind = text[at + word.len()..].chars().next();
                !before.is_some_and(|c| c.is_alphanumeric() || matches!(c, '\\' | '{' | '-' | '$' | '_'))
                    && behind.is_some_and(|c| c.is_whitespace() || c == '~' || c == ',')
            };
            out.openers.extend(
                text.match_indices(word).map(|(at, _)| at).filter(|&at| is_word(at)).map(|at| (at, word, opener)),
            );
        }
        out.openers.sort_unstable_by_key(|(at, word, _)| (*at, *word));
        out.items.extend(text.match_indices(r"\item").map(|(at, _)| (at, true)));
        for end in [r"\end{itemize", r"\end{enumerate", r"\end{description"] {
            out.items.extend(text.match_indices(end).map(|(at, _)| (at, false)));
        }
        out.items.sort_unstable();
        for stop in [". ", ".\n", ".$ ", ".\\]", ".\\end{", ".$$", "\n\n", "? ", "?\n"] {
            let abbreviates = |at: usize| ABBREVIATED.iter().any(|w| text[..at].ends_with(w));
            out.stops.extend(text.match_indices(stop).map(|(at, _)| at).filter(|at| stop != ". " || !abbreviates(*at)));
        }
        out.stops.sort_unstable();
        out.breaks = BREAKS.iter().flat_map(|b| places_of(text, b)).collect();
        out.breaks.sort_unstable();
        for (pair, words) in PAIRS.iter().enumerate() {
            for (which, word) in words.iter().enumerate() {
                let of_kind = |at: &usize| names_a_kind(text, *at, word);
                let all = text.match_indices(word).map(|(at, _)| at).filter(of_kind);
                out.kinds.extend(all.map(|at| (at, pair, which)));
            }
        }
        out.kinds.sort_unstable();
        let lower = text.to_lowercase();
        // Small letters of another length would move the places.
        if lower.len() == text.len() {
            out.contrasts = CONTRASTS.iter().flat_map(|w| lower.match_indices(w)).map(|(at, _)| at).collect();
            out.contrasts.sort_unstable();
        }
        out
    }

    /// Whether what is said at `from` may be of another case than what stands at `to`. Where it has to be the same, `is_sure`, any word that
    /// may begin a case parts them, and so does an item of a list; else the same word again, as in "For a disc … For a ring".
    pub fn parted(&self, from: usize, to: usize, is_sure: bool) -> bool {
        let passes = |all: &[usize]| all.partition_point(|p| *p < from) < all.partition_point(|p| *p < to);
        if is_sure && (passes(&self.breaks) || passes(&self.contrasts)) {
            return true;
        }
        // "The right branch … The left branch".
        let (kinds, later) = [from, to].map(|at| self.kinds.partition_point(|(place, ..)| *place < at)).into();
        let own = self.kinds[..kinds].last().filter(|(at, ..)| at + KIND >= from);
        let is_other = |pair: usize, which: usize| move |k: &&(usize, usize, usize)| k.1 == pair && k.2 != which;
        if is_sure && own.is_some_and(|k| self.kinds[kinds..later].iter().any(|o| is_other(k.1, k.2)(&o))) {
            return true;
        }
        let before = |at: usize| self.items.partition_point(|(place, _)| *place < at);
        let (first, last) = (before(from), before(to));
        let in_item = first > 0 && self.items[first - 1].1;
        if is_sure && in_item && self.items[first..last.max(first)].iter().any(|(_, begins)| *begins) {
            return true;
        }
        let first = self.openers.partition_point(|(place, ..)| *place < from);
        let last = self.openers.partition_point(|(place, ..)| *place < to);
        // What has to be the same is parted by the word that opens its case, though another word stands between.
        let is_case = |o: &&(usize, &str, Opener)| !is_sure || o.2 != Opener::Opens;
        let Some(&(opened, own, opener)) = self.openers[..first].iter().rev().find(is_case) else { return false };
        let ends = self.stops.partition_point(|stop| *stop < opened);
        let is_open = self.stops.get(ends).is_none_or(|stop| *stop >= from);
        if !is_open || opener == Opener::Opens {
            return false;
        }
        // "At t = 0, v = v₀." is said of that time alone.
        if opener == Opener::Moment && self.stops.get(ends).is_some_and(|stop| *stop < to) {
            return true;
        }
        self.openers[first..last.max(first)].iter().any(|(_, word, _)| is_sure || *word == own)
    }
}

/// What the words around a formula do with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stance {
    /// They say it.
    Said,
    /// They deny it.
    Denied,
    /// They ask for it, or offer it as a choice.
    Asked,
}

/// What the words of its sentence do with the formula between two places of a text.
pub fn stance(text: &str, from: usize, to: usize) -> Stance {
    let near = |at: usize| next_character(text, at);
    let from = near(from.min(text.len()));
    let before = &text[near(from.saturating_sub(BEFORE))..from];
    let trimmed =
        |t: &str| t.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\' | '{')).len();
    let opened = &before[..trimmed(before)];
    let opened = opened.strip_suffix(r"\displaystyle").map_or(opened, |rest| &rest[..trimmed(rest)]);
    if CHOICES.iter().any(|c| opened.ends_with(c))
        || opened.ends_with(']') && opened.rsplit('\\').next().is_some_and(|w| w.starts_with("choice"))
    {
        return Stance::Asked;
    }
    if is_item_to_solve(text, from) {
        return Stance::Asked;
    }
    let start = [". ", ".\n", "\n\n", "? ", r".\]", ".$", r".\end"]
        .iter()
        .filter_map(|stop| before.rfind(stop).map(|at| at + stop.len()))
        .max();
    let before = before[start.unwrap_or(0)..].to_lowercase();
    let behind = &text[near(to.min(text.len()))..near((to + BEHIND).min(text.len()))];
    let stop = [". ", ".\n", "\n\n", "? ", "?\n", r".\]", ".$", r".\end", r"?\]", "?$"]
        .iter()
        .filter_map(|stop| behind.find(stop).map(|at| (at, *stop)))
        .min();
    let (behind, asks) = match stop {
        Some((at, stop)) => (&behind[..at], stop.starts_with('?')),
        None => (behind, behind.trim_end().ends_with('?')),
    };
    let behind = behind.to_lowercase();
    if DENIES.iter().any(|w| before.contains(w) || behind.contains(w)) {
        return Stance::Denied;
    }
    if asks { Stance::Asked } else { Stance::Said }
}

/// Words before a list whose items are equations that are to be solved, or statements that are to be judged.
const POSES: &[&str] = &[
    "solve ",
    "solve:",
    "solve the",
    "true or false",
    "are true",
    "is true",
    "are identities",
    "find all solutions",
    "find all real",
    "determine whether",
    "determine if",
    "risolv",
    "résou",
    "resuelv",
    "löse",
];
/// The longest text before a list that is looked at, and the longest list.
const STEM: usize = 200;
const LIST: usize = 3000;

/// Whether a place stands in an item of a list, right behind its beginning, and the words before the list pose its items.
fn is_item_to_solve(text: &str, at: usize) -> bool {
    let before = &text[next_character(text, at.saturating_sub(LIST))..at];
    let item = [r"\item", r"\task", r"\part"].iter().filter_map(|i| places_of(before, i).last()).max();
    let Some(item) = item.filter(|i| before[*i..].split_whitespace().count() < 4) else { return false };
    let lists = ["enumerate", "itemize", "tasks", "extasks", "multicols", "parts"];
    let begin = |l: &&str| before[..item].rfind(&format!("\\begin{{{l}}}"));
    let Some(begin) = lists.iter().filter_map(begin).max() else { return false };
    let stem = before[next_character(before, begin.saturating_sub(STEM))..begin].to_lowercase();
    let stem = stem.rsplit("\n\n").find(|p| !p.trim().is_empty()).unwrap_or_default();
    POSES.iter().any(|w| stem.contains(w))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_part_what_is_said_in_them() {
        let parted = |text: &str, sure: bool| {
            let (from, to) = (text.find('1').expect("a place"), text.find('2').expect("a place"));
            Cases::of(text).parted(from, to, sure)
        };
        assert!(parted("For a disc 1, so. For a ring 2", false));
        assert!(!parted("For a disc 1, so that 2", true));
        assert!(!parted("A disc has 1. For a ring 2", true));
        assert!(parted("For all 1 holds. If not, 2", true) && !parted("For all 1 holds. If not, 2", false));
        assert!(parted("At the point 1 holds. It is 2", false) && !parted("At the point 1 holds, so 2", true));
        assert!(parted(r"\begin{itemize}\item 1 \item 2", true) && !parted(r"1 \begin{itemize}\item 2", true));
        assert!(parted("We have 1. If not, however, 2", true) && !parted("We have 1. If not, however, 2", false));
        assert!(!parted("For a disc it turns. The sum is 1. For a ring 2", true));
        assert!(parted("The right branch is 1. The left branch, 2", true));
        assert!(!parted("The right branch is 1. The right branch, 2", true));
        assert!(!parted("The right-hand side is 1. The left-hand side is 2", true));
        assert!(!parted("The right side of the equation is 1. The left side of the equation is 2", true));
        assert!(parted("For points below, Now Thm. 5 says 1. For points above, 2", true));
        assert!(!parted("For a disc. Now 1. For a ring, 2", true));
        assert!(parted("For points below, Thm. 5 says 1. For points above, 2", true));
    }

    #[test]
    fn what_is_denied_or_asked_is_not_said() {
        let of = |text: &str| {
            let at = text.find('1').expect("a place");
            stance(text, at, at + 1)
        };
        assert_eq!(of("It is not true that 1."), Stance::Denied);
        assert_eq!(of("The formula 1 is false. Then"), Stance::Denied);
        assert_eq!(of("This is not true. Then 1 holds."), Stance::Said);
        assert_eq!(of("For which is 1 a solution? Then"), Stance::Asked);
        assert_eq!(of(r"\choice{$1$}"), Stance::Asked);
        assert_eq!(of(r"\task $\displaystyle 1$"), Stance::Asked);
        assert_eq!(of(r"Solve the following: \begin{enumerate} \item $1$"), Stance::Asked);
        assert_eq!(of(r"We list: \begin{enumerate} \item $1$"), Stance::Said);
    }
}
