//! Page one of every derivation of this project: it has all of its parts, and fits.

use std::path::Path;

use rederive::report::{front_markdown, front_page, page, tex_summary};

use crate::checked::checked;

/// Most rows and columns of the matrix, its heads apart.
const MATRIX: (usize, usize) = (10, 6);
/// The longest page one of a terminal, in lines.
const LINES: usize = 60;

/// Of nothing that these tell there are two sides along a motion.
const WITHOUT_A_PICTURE: [&str; 0] = [];

fn derivations() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations");
    let entries = std::fs::read_dir(folder).expect("derivations").map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = entries.map(|name| name.to_string_lossy().into_owned()).collect();
    names.retain(|name| name.ends_with(".toml"));
    names.sort();
    names
}

/// The part of a page between two marks.
fn between<'a>(page: &'a str, from: &str, to: &str) -> &'a str {
    let rest = page.split_once(from).map_or("", |(_, rest)| rest);
    rest.split_once(to).map_or("", |(part, _)| part)
}

/// What page one of a page has, counted.
#[derive(Debug)]
struct Counts {
    formulas: usize,
    rows: usize,
    columns: usize,
    verdicts: usize,
    /// The strip of all claims, and both sides of a claim along a motion or at its values.
    strips: usize,
    pictures: usize,
    cards: usize,
    chains: usize,
    hypotheses: usize,
}

impl Counts {
    fn of(page: &str) -> Counts {
        let front = between(page, "id=/front>", "<div class=counts");
        let matrix = between(front, "<div class=matters>", "<div class=cards>");
        let cards = between(front, "<div class=cards>", "<div class=concludes>");
        let chains = between(front, "<div class=concludes>", "<div class=unsaid>");
        let unsaid = between(front, "<div class=unsaid>", "<div class=foot>");
        let said = unsaid.split_once("Used and not said").map_or("", |(_, said)| said);
        Counts {
            formulas: cards.matches("<math").count(),
            rows: matrix.matches("<th scope=row>").count(),
            columns: matrix.matches("<th scope=col").count(),
            verdicts: matrix.matches("class=\"mark").count(),
            strips: matrix.matches("<svg class=strip").count(),
            pictures: cards.matches("<path class=left d=").count(),
            cards: cards.matches("<div class=card>").count(),
            chains: chains.matches("<div class=chain>").count(),
            hypotheses: said.matches("<p").count(),
        }
    }

    /// What is missing, where a chain is due if the claims of the paper rest on one another.
    fn missing(&self, argues: bool) -> Vec<&'static str> {
        let parts = [
            ("formula", self.formulas > 0),
            ("matrix", (1..=MATRIX.0).contains(&self.rows) && (1..=MATRIX.1).contains(&self.columns)),
            ("verdict", self.verdicts > 0),
            ("strip", self.strips == 1),
            ("picture", self.pictures > 0),
            ("card", self.cards > 0),
            // Where no claim of the paper rests on another there is no chain, and no room is lost on saying so.
            ("chain", self.chains > 0 || !argues),
            ("hypotheses", self.hypotheses > 0),
        ];
        parts.into_iter().filter(|(_, is_there)| !is_there).map(|(part, _)| part).collect()
    }
}

#[test]
fn every_page_one_has_all_of_its_parts() {
    let names = derivations();
    assert!(names.len() >= 18, "{names:?}");
    for name in names {
        let (derivation, account) = &*checked(Path::new("derivations").join(&name));
        let whole = page(derivation, account);
        let is_claim = |name: &String| derivation.claims.iter().any(|c| c.id == *name || c.name() == *name);
        let of_paper = || derivation.claims.iter().filter(|c| c.role.is_of_the_paper());
        let argues = of_paper().any(|c| c.conclusion || c.follows_from.iter().chain(&c.rests_on).any(is_claim));
        let counts = Counts::of(&whole);
        let missing = counts.missing(argues);
        let unseen: &[&str] = if WITHOUT_A_PICTURE.contains(&name.as_str()) { &["picture"] } else { &[] };
        assert_eq!(missing, unseen, "{name}: {counts:?}");
        assert!(!whole.contains("of no claim"), "{name}");
        let text = front_page(derivation, account, false);
        assert!(text.lines().count() <= LINES, "{name}: {} lines\n{text}", text.lines().count());
        let too_wide = |line: &&str| line.chars().count() > 100 && line.trim().contains(' ');
        assert_eq!(text.lines().find(too_wide), None, "{name}");
        for part in ["Used and not said", "To repeat it:"] {
            assert!(front_markdown(derivation, account).contains(part), "{name}: {part}");
            assert!(tex_summary(derivation, account).contains(part), "{name}: {part}");
        }
    }
}

/// Each count fails where its part is taken away, and no other one but what stands inside of it.
#[test]
fn a_part_that_is_taken_away_is_missed() {
    let (derivation, account) = &*checked(Path::new("derivations/deriglazov-comment.toml"));
    let whole = page(derivation, account);
    assert!(Counts::of(&whole).missing(true).is_empty());
    for (mark, part) in [
        ("<math", "formula"),
        ("<th scope=row>", "matrix"),
        ("<th scope=col", "matrix"),
        ("class=\"mark", "verdict"),
        ("<svg class=strip", "strip"),
        ("<path class=left d=", "picture"),
        ("<div class=card>", "card"),
        ("<div class=chain>", "chain"),
        ("Used and not said", "hypotheses"),
    ] {
        assert!(whole.contains(mark), "{mark}");
        assert_eq!(Counts::of(&whole.replace(mark, "<i ")).missing(true), [part], "{mark}");
    }
    assert_eq!(Counts::of("").missing(true).len(), 8);
    assert_eq!(Counts::of("").missing(false).len(), 7);
}

/// Claims have the words of the paper, not the names that a file has for them, wherever they are told in a matrix or a chain.
#[test]
fn claims_have_their_words_in_matrix_and_chains() {
    let (derivation, account) = &*checked(Path::new("derivations/deriglazov-comment.toml"));
    let whole = page(derivation, account);
    let front = between(&whole, "id=/front>", "<div class=counts");
    let matrix = between(front, "<div class=matters>", "<div class=cards>");
    let words = "title=\"point-of-the-body\">R(t) applied to the position";
    let plain = words.replace('"', "");
    assert!(matrix.contains(words) || matrix.contains(&plain), "{matrix}");
    assert!(!matrix.contains(">point-of-the-body<"), "{matrix}");
    let chains = between(front, "<div class=concludes>", "<div class=unsaid>");
    let steps = chains.split(" → ").count();
    assert!(steps > 8 && !chains.contains(">unit-start<") && !chains.contains(">only-through-unit<"), "{chains}");
    let text = front_page(derivation, account, false);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("“R(t) applied…” ◐ → “The equations must be…” ◐ →"), "{text}");
    // What a chain shares with one above it is told once.
    assert!(text.contains("as under B → “Only solutions that…” ◐ → D"), "{text}");
}

/// Two constants are two levels on the page; on a terminal the line with their values is enough.
#[test]
fn constants_have_a_picture_on_the_page() {
    let (derivation, account) = &*checked(Path::new("derivations/deriglazov-comment.toml"));
    let whole = page(derivation, account);
    let unsaid = between(&whole, "<div class=unsaid>", "<div class=foot>");
    assert!(unsaid.contains("<svg class=levels") && unsaid.contains(">right 60.2479<"), "{unsaid}");
    let (derivation, account) = &*checked(Path::new("derivations/pendulum.toml"));
    let whole = page(derivation, account);
    let cards = between(&whole, "<div class=cards>", "<div class=concludes>");
    assert!(cards.contains("<svg class=levels"), "what is tried at one time has a picture, too");
    // A bound is a formula, in LaTeX too.
    let tex = tex_summary(derivation, account);
    assert!(tex.contains("not below $10^{-4}$") && !tex.contains("textless"), "{tex}");
}

/// What stands as it is said, and fails where the paper needs more, is told with its numbers: whether the printed equations hold, and
/// where what other claims assume does not.
#[test]
fn what_stands_under_a_condition_is_told_with_numbers() {
    let (derivation, account) = &*checked(Path::new("derivations/deriglazov-comment.toml"));
    let text = front_page(derivation, account, false).split_whitespace().collect::<Vec<_>>().join(" ");
    for words in [
        // What uses a condition that nothing says does not simply hold as it is printed.
        "t9, and t10 hold as printed; t11 and t15 hold under conditions that they do not say; t8 only in one of its readings.",
        "holds as stated (for motions with R(0) = 1), but fails on 28 of 49 motions as used (for every motion of a rigid body, as on \
         the way to t15).",
        "Stated and used differently: “Energy and momentum are related…”, and 6 more.",
        // What is constant has no time, and its sides have their names.
        "On racket-letter-in: left 2E = 4.45012, right I⁻¹ᵢ mᵢ² = 60.2479.",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let markdown = front_markdown(derivation, account);
    for words in [
        "(18 readings assume it), and 6 more.",
        "as the paper uses it: For every motion of a rigid body, as on the way to t15; **fails** on 28 of 49 motions (certified): ",
        "On racket-letter-in (racket with its first two axes exchanged): left",
        "; both constant).",
    ] {
        assert!(markdown.contains(words), "{words}: {markdown}");
    }
    let (derivation, account) = &*checked(Path::new("derivations/pendulum.toml"));
    assert!(!front_page(derivation, account, false).contains("as the paper uses it"), "nothing more is used there");
    let markdown = front_markdown(derivation, account);
    assert!(!markdown.contains("Stated and used differently"), "{markdown}");
}

/// Each conclusion says as what it was tested, and where it fails with the quantities of the motion, or how it is known to hold.
#[test]
fn conclusions_are_told_with_their_motion_and_how_sure_they_are() {
    let (derivation, account) = &*checked(Path::new("derivations/deriglazov-comment.toml"));
    let text = front_page(derivation, account, false).split_whitespace().collect::<Vec<_>>().join(" ");
    for words in [
        "Of its 4 conclusions A, B, and D do not hold; C holds, but rests on “R(t) applied to the position…”, which on the motions tried holds \
         exactly where R(0) = 1.",
        // Of several readings that fail the one that is refuted on most motions, and on how many motions any of them is.
        "A ✕ The solutions t15 have none of the properties of a tennis racket. The third axis stays on its side of the plane normal to \
         m; fails on 7 of 9 (at samples).",
        "A The solutions t15 have none… – ✕ 7/9",
        "→ A B ✖",
        "→ B C",
        "→ D Stated",
        "where m=(0,0,m₃), R(0) = 1; holds at all samples of 3 motions",
        "the contrary holds: Along every motion with momentum along z",
        "proved, given others",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let unsaid = text.split_once("Used and not said").map_or("", |(_, rest)| rest);
    assert!(unsaid.contains("I₁ ≠ I₂ (t15, ") && unsaid.contains("I₃ between I₁ and I₂"), "{unsaid}");
    // The paper itself demands it: it is used in more places than say so.
    assert!(
        unsaid.contains("Said once, used elsewhere: R(0) = 1 (") && !unsaid.contains("strictly between"),
        "{unsaid}"
    );
    let markdown = front_markdown(derivation, account);
    // One list, of which page one has the beginning.
    let whole = page(derivation, account);
    assert!(
        whole.contains("Said by the paper in one place, and used in others:")
            && !whole.contains("What was left unsaid")
    );
    // A terminal has no room for what else fails.
    let also = "in another reading, too: “While the handle makes one turn about m, the face stays where it is” fails on the one motion \
                (at samples); 8 motions in all.";
    assert!(markdown.contains(also) && markdown.contains("The first step fails"), "{markdown}");
    // What a printed formula uses comes before what is technical.
    assert!(
        markdown.contains("Conventions: euler angles: zxz") && markdown.contains("a × b, right-handed"),
        "{markdown}"
    );
    assert!(markdown.contains("Remark of the file: Every formula is right where it was derived."), "{markdown}");
}

/// Where a claim fails on a motion, both of its sides are drawn along it.
#[test]
fn a_failure_on_a_motion_has_its_picture() {
    for name in ["pendulum.toml", "kepler.toml"] {
        let (derivation, account) = &*checked(Path::new("derivations").join(name));
        let whole = page(derivation, account);
        let cards = between(&whole, "<div class=cards>", "<div class=concludes>");
        assert!(cards.contains("class=left d=") && cards.contains("class=right d="), "{name}");
    }
}

/// The gap of the argument: premises that exclude one another, and an effect that a motion shows all the same, are on the first page.
#[test]
fn what_the_argument_needs_and_what_fails_is_on_the_first_page() {
    let (derivation, account) = &*checked(Path::new("derivations/deriglazov-comment.toml"));
    let text = front_page(derivation, account, false).split_whitespace().collect::<Vec<_>>().join(" ");
    for words in [
        "The paper also needs “With R(0) = 1 and m along z, θ can differ from 0”, which fails on all 3.",
        "A motion with R(0) = 1 does not show the racket effect",
        "165.7°",
        "Remark of the file: Every formula is right where it was derived.",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    // A capital of a formula stays one.
    assert!(!text.contains("r(0)"), "{text}");
}

/// Where the words of a claim may be right and its formula is wrong, the sentence shows the formula, and the right one.
#[test]
fn a_sentence_is_not_called_false_without_its_formula() {
    let (derivation, account) = &*checked(Path::new("derivations/kepler-laws.toml"));
    let text = front_page(derivation, account, false);
    assert!(!text.contains("Conventions: ;") && !text.contains("too long to print"), "{text}");
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("left T = "), "the side that has a short formula is named: {text}");
}

/// One word for a motion, one way to write numbers, and sentences that end.
#[test]
fn readers_see_one_word_and_one_way_to_write_numbers() {
    for name in ["deriglazov-comment.toml", "kepler.toml", "pendulum.toml"] {
        let (derivation, account) = &*checked(Path::new("derivations").join(name));
        let whole = page(derivation, account);
        let body = between(&whole, "<body", "<script type=\"text/plain\"");
        let seen: Vec<&str> = body.split('<').filter_map(|part| Some(part.split_once('>')?.1)).collect();
        let code = ["[[trajectory]]", "trajectory ="];
        let said = seen.iter().find(|t| t.to_lowercase().contains("trajector") && !code.iter().any(|c| t.contains(c)));
        assert_eq!(said, None, "{name}");
        let terminal = front_page(derivation, account, false);
        assert!(!terminal.contains("trajector"), "{name}");
        for text in [terminal, front_markdown(derivation, account)] {
            let is_scientific = |word: &str| {
                let word = word.trim_matches(|c: char| !c.is_ascii_digit());
                word.contains("e-") && word.parse::<f64>().is_ok()
            };
            assert_eq!(text.split_whitespace().find(|w| is_scientific(w)), None, "{name}: {text}");
        }
    }
}

/// The first page of a derivation on a terminal, on one line, and as Markdown.
fn first_pages(name: &str) -> (String, String) {
    let (derivation, account) = &*checked(Path::new("derivations").join(name));
    let text = front_page(derivation, account, false);
    (text.split_whitespace().collect::<Vec<_>>().join(" "), front_markdown(derivation, account))
}

/// What fails on a motion that was drawn at random stands on the motions of the file alone: sentence, matrix, chain and heading say so.
#[test]
fn a_claim_that_fails_on_a_drawn_motion_does_not_simply_stand() {
    let (text, markdown) = first_pages("schwarzschild.toml");
    for words in [
        "Of 10 claims 9 stand and 1 stands on the motions of the file, but fails on another, drawn at random.",
        "≢ / ✕",
        "≢ / ✕: on a drawn motion",
        "No claim of the paper fails on a motion of the file",
        "One claim fails on a motion drawn at random: normalisation",
        "“The time of the motion…” ● (✕ on a drawn motion).",
        "3 proved but for special cases; 3 proved, given others (of these 1 but for special cases)",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(!text.contains("All 10 claims") && !text.contains("no step fails"), "{text}");
    // Where a premise does not hold nothing is said: what rests on it is not refuted with it.
    let (derivation, account) = &*checked(Path::new("derivations/schwarzschild.toml"));
    let whole = page(derivation, account);
    assert!(!whole.contains("which is refuted") && whole.contains("where it does not, this says nothing"), "{text}");
    assert!(
        markdown.contains(
            "Of motions on which normalisation fails nothing is said by what is proved given it: radial, \
             radial-acceleration, orbit."
        ),
        "{markdown}"
    );
    assert!(
        markdown.contains("(for comparison, [wrong-orbit]") || markdown.contains("(for comparison, `wrong-orbit`"),
        "{markdown}"
    );
}

/// Two motions tell no condition: what separates them is not said, unless the file names it.
#[test]
fn what_separates_two_motions_is_no_condition() {
    let (text, markdown) = first_pages("rabi.toml");
    assert!(!text.contains("exactly where") && !markdown.contains("exactly where"), "{markdown}");
    assert!(markdown.contains("Fails on 1 of 2 motions"), "{markdown}");
    let (text, _) = first_pages("kepler-laws.toml");
    assert!(text.contains("it holds exactly where the planet runs counter-clockwise"), "{text}");
}

/// What follows from what a claim assumes, and from the signs that are declared, is said: √(c² − v²) has a value where −c < v < c.
#[test]
fn what_follows_from_what_is_assumed_is_not_unsaid() {
    let (text, _) = first_pages("lorentz.toml");
    let unsaid = text.split_once("Used and not said: ").map_or("", |(_, rest)| rest);
    assert!(unsaid.starts_with("c²-v² ≥ 0 (3 claims); +2."), "{unsaid}");
    let (text, markdown) = first_pages("pendulum.toml");
    assert!(text.contains("Used and not said: nothing.") && !markdown.contains("\\vert ≤ 1"), "{text}");
}

/// What separates the members of a family is said where the family is, and not denied of all motions.
#[test]
fn what_separates_members_is_said_once() {
    let (derivation, account) = &*checked(Path::new("derivations/pendulum.toml"));
    let whole = page(derivation, account);
    let claim = between(&whole, "id=small-angle-period", "id=small-angle-motion");
    assert!(!claim.is_empty() && claim.contains("fresh members"), "{claim}");
    assert!(!claim.contains("no condition that was tried separates"), "{claim}");
}

/// What is wrong is marked where it is found to be: what fits the fields that are put in does not tell whether these are wrong.
#[test]
fn a_part_that_is_not_found_wrong_is_not_marked() {
    let (derivation, account) = &*checked(Path::new("derivations/fluid.toml"));
    let whole = page(derivation, account);
    let cards = between(&whole, "<div class=cards>", "<div class=unsaid>");
    assert!(cards.contains("for the fields of its ranges alone") && !cards.contains("class=wrong"), "{cards}");
    let (_, markdown) = first_pages("fluid.toml");
    assert!(markdown.contains("component 1, has the sides −2 and 0"), "{markdown}");
    assert!(!markdown.contains("cells") && markdown.contains("for all values, or all of the ranges"), "{markdown}");
}

/// What was tried on the fields of one flow is a correction for that flow.
#[test]
fn a_correction_for_one_flow_says_so() {
    let (_, markdown) = first_pages("fluid.toml");
    assert!(
        markdown.contains("holds for the fields of its ranges alone: ") && !markdown.contains("holds instead"),
        "{markdown}"
    );
}

/// What is proved along one motion is so at every time of it; that it is proved is said where it is proved for all values.
#[test]
fn a_row_does_not_prove_what_it_refutes() {
    for name in ["lorentz.toml", "circuit.toml"] {
        let (derivation, account) = &*checked(Path::new("derivations").join(name));
        let text = front_page(derivation, account, false);
        let refuted: Vec<&str> =
            text.lines().filter(|line| line.starts_with("  ") && line.trim_end().ends_with('≢')).collect();
        assert!(!refuted.is_empty() && refuted.iter().all(|row| !row.contains('◆')), "{name}: {text}");
        assert!(text.contains("◆ proved ■"), "{name}: {text}");
    }
}

/// The threshold of a family is on page one; where a claim does not apply its sign says that, not the failure on another motion.
#[test]
fn a_threshold_is_told_and_what_does_not_apply_is_not_refuted() {
    let (derivation, account) = &*checked(Path::new("derivations/pendulum.toml"));
    let text = front_page(derivation, account, false);
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains(
            "on the members of amplitudes that were tried it holds exactly where q<0.04 (24 of 24 fresh members agree)"
        ),
        "{words}"
    );
    assert!(words.contains("c circling, separatrix (from the top);"), "{words}");
    let row = text.lines().find(|line| line.trim_start().starts_with("The period of small oscillations is…"));
    let signs: Vec<&str> = row.unwrap_or_default().split_whitespace().skip(6).collect();
    assert_eq!(signs.get(2), Some(&"–"), "{text}");
}
