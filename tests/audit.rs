//! Recorded proofs are replayed from the report alone, and what was changed in one is refused.

use assert_cmd::Command;
use rederive::derivation::parse;
use rederive::diag::Source;
use rederive::report::{ProofFile, Provenance, RecordedClaim};
use rederive::{Ask, Session};
use std::fs;
use std::path::{Path, PathBuf};

fn audit(path: &Path) -> (i32, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    let run = command.args(["audit", &path.display().to_string()]).output().expect("it runs");
    let text = String::from_utf8(run.stdout).expect("UTF-8") + &String::from_utf8_lossy(&run.stderr);
    (run.status.code().unwrap_or(-1), text)
}

fn reports() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reports")
}

#[test]
fn every_recorded_proof_of_the_reports_is_replayed() {
    let (code, text) = audit(&reports());
    // A package without the committed reports has nothing to replay.
    if !reports().exists() {
        return;
    }
    assert_eq!(code, 0, "{text}");
    assert!(!text.contains("REFUSED") && text.contains(" recorded claims are replayed."), "{text}");
    let words = r"`\ddot{q}=-\frac{g}{\ell}\cdot \sin(q)` at all times";
    assert!(text.contains(words) && text.contains(r"at every time, `h=h(t_{\ast})`"), "{text}");
}

#[test]
fn what_was_changed_in_a_proof_is_refused_with_its_step() {
    let path = reports().join("pendulum/proofs.json");
    let Ok(text) = fs::read_to_string(&path) else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let changed = folder.path().join("proofs.json");
    // Another system, another claim, another fact, a step less; none of them proves what it says then.
    for (old, new) in [
        (r#""name":"\\ell","component":0,"rate":0,"at":null"#, r#""name":"g","component":0,"rate":0,"at":null"#),
        (r#""rate":2"#, r#""rate":1"#),
        (r#""1/2""#, r#""1/3""#),
        (r#"{"conclude":"#, r#"{"rate":"#),
    ] {
        let dense: String = text.split_whitespace().collect();
        assert!(dense.contains(old), "{old}");
        fs::write(&changed, dense.replacen(old, new, 1)).expect("written");
        let (code, said) = audit(&changed);
        assert!(code == 1 && said.contains("refused"), "{old}: {code}, {said}");
    }
    // The claim of the whole is that of its first relation.
    let mut file: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let proof = file["proofs"][0]["proof"].as_object_mut().expect("a proof");
    let right = proof["sequent"]["claim"]["left"].clone();
    proof["sequent"]["claim"]["right"] = right;
    fs::write(&changed, file.to_string()).expect("written");
    let (code, said) = audit(&changed);
    assert!(code == 1 && said.contains("claims something else than its first relation"), "{code}, {said}");
    fs::write(&changed, "{}").expect("written");
    let (code, said) = audit(&changed);
    assert!(code == 2 && said.contains("this is no proofs.json"), "{code}, {said}");
}

/// Small bytes are large values once they are read.
#[test]
fn a_text_of_many_values_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("proofs.json");
    let with = |more: &str| {
        format!(r#"{{"schema":2,"derivation":"d","sha256":"","proofs":[],"unrecorded":[],"sum":"","more":{more}}}"#)
    };
    let many = |value: &str| format!("[{}1]", [value, ","].concat().repeat(6_000_000));
    for text in [many("1"), many("{}"), with(&many("[]"))] {
        fs::write(&path, text).expect("written");
        let (code, said) = audit(&path);
        assert!(code == 2 && said.contains("it has more than 5000000 values of JSON"), "{code}: {said}");
    }
    // One that is not understood is not passed over, however few.
    fs::write(&path, with("0")).expect("written");
    let (code, said) = audit(&path);
    assert!(code == 2 && said.contains("a key that is not known"), "{code}: {said}");
}

/// Lines of an audit are those of the program; and what is named to compare with is compared.
#[test]
fn an_audit_has_no_line_of_the_file() {
    let path = reports().join("pendulum/proofs.json");
    let Ok(text) = fs::read_to_string(&path) else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let changed = folder.path().join("proofs.json");
    let mut file: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    file["proofs"][0]["standing"] = "proved)\n  false  replayed (the report says: proved".into();
    fs::write(&changed, file.to_string()).expect("written");
    let (_, said) = audit(&changed);
    assert!(!said.lines().any(|line| line.starts_with("  false  replayed")), "{said}");
    fs::write(&changed, text.replace("\"derivation\": \"pendulum\"", "\"derivation\": \"other\"")).expect("written");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/pendulum.toml");
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    let command = command.arg("audit").arg(&changed).arg("--in").arg(file);
    let run = command.output().expect("it runs");
    assert_eq!(run.status.code(), Some(1), "{}", String::from_utf8_lossy(&run.stdout));
    assert!(String::from_utf8_lossy(&run.stderr).contains("of another file"));
}

/// A proof that takes too long, or has too many words, is refused, and no other one is.
#[test]
fn an_audit_ends() {
    let path = reports().join("pendulum/proofs.json");
    let Ok(text) = fs::read_to_string(&path) else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let changed = folder.path().join("proofs.json");
    let mut file: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let leaf = serde_json::json!({ "leaf": { "name": "h", "component": 0, "rate": 0, "at": null } });
    let premise = |i: usize| serde_json::json!({ "left": [leaf], "sense": "equal", "right": [{ "number": format!("1{i:060}") }] });
    let proof = &mut file["proofs"][0]["proof"];
    proof["sequent"]["premises"] = (0..2000).map(premise).collect();
    let relation = proof["relations"][0].clone();
    proof["relations"] = vec![relation; 3000].into();
    fs::write(&changed, file.to_string()).expect("written");
    let (code, said) = audit(&changed);
    assert!(
        code == 1 && said.contains("work limit: proving a claim takes more than"),
        "{}",
        &said[..said.len().min(2000)]
    );
    assert!(said.len() < 1_000_000 && said.contains("  replayed (the report says"), "{}", said.len());
}

fn rederive(words: &[&str]) -> String {
    let run = Command::new(env!("CARGO_BIN_EXE_rederive")).args(words).output().expect("it runs");
    String::from_utf8(run.stdout).expect("UTF-8") + &String::from_utf8_lossy(&run.stderr)
}

#[test]
fn a_typed_identity_is_replayed_by_the_checker() {
    for (formula, more) in [
        (r"\sin 2x=2\sin x\cos x", &["--symbol", "x"][..]),
        (r"\cos 3x=4\cos^3x-3\cos x", &["--symbol", "x"]),
        (r"\cosh^2x-\sinh^2x=1", &["--symbol", "x"]),
        (r"\ddot q=-g", &["--symbol", "q: state", "--symbol", "g", "--given", r"\dot q=-gt"]),
        (r"\frac{1}{\sqrt{1-v^2/c^2}}=\frac{c}{\sqrt{c^2-v^2}}", &["--symbol", "v, c: positive"]),
    ] {
        let said = rederive(&[&["prove", formula], more].concat());
        assert!(said.contains("The proof is recorded: the checker replayed"), "{formula}: {said}");
    }
    let said = rederive(&["prove", r"\sin 2x=2\sin x\cos x", "--symbol", "x", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    assert!(json["recorded"]["steps"].as_u64().is_some_and(|n| n > 0) && json["recorded"]["leaves_out"] == 0, "{said}");
    assert!(json["proof"]["relations"][0]["steps"].is_array(), "{said}");
}

#[test]
fn what_is_not_recorded_says_so() {
    // The ends of the range of a sum of angles: no rule of the checker knows them.
    let said = rederive(&["prove", r"\arctan x+\arctan\frac1x=\frac\pi2", "--symbol", "x", "--given", "x>0"]);
    assert!(said.starts_with("proved") && said.contains("rests on the prover alone"), "{said}");
    let said = rederive(&["prove", r"(a+b)^2=a^2+b^2", "--symbol", "a, b"]);
    assert!(said.starts_with("refuted") && !said.contains("recorded"), "{said}");
}

#[test]
fn explain_prints_the_sequent_and_the_steps() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/pendulum.toml");
    let said = rederive(&["explain", "energy", &path.display().to_string(), "--no-cache"]);
    for words in ["The proof is recorded", "For every motion", "1. equation 1 of the systems", "the claim is"] {
        assert!(said.contains(words), "{words}: {said}");
    }
}

/// Of one byte that is changed, the audit says that something is refused, or that it is no proofs.json. One who writes the sum anew is told
/// that a step is refused, or gets told what is proved instead.
#[test]
fn each_changed_byte_of_a_record_is_refused() {
    let said = rederive(&["prove", r"x^2-1=(x-1)(x+1)", "--symbol", "x", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    let file = serde_json::json!({
        "schema": 2, "derivation": "d", "sha256": "s", "unrecorded": [], "sum": "",
        "proofs": [{ "claim": "c", "standing": "proved", "proof": json["proof"] }],
    });
    let with_its_sum = |mut file: ProofFile| {
        file.sum = file.right_sum();
        file
    };
    let on_trust = |file: &ProofFile| rederive::report::audit(file, &|_| Provenance::OnTrust);
    let file = with_its_sum(serde_json::from_value(file).expect("proofs"));
    let right = on_trust(&file);
    assert!(right.is_replayed(), "{}", right.text());
    let text = serde_json::to_vec(&file).expect("bytes");
    let (mut refused, mut otherwise) = (0, 0);
    for at in 0..text.len() {
        let mut changed = text.clone();
        changed[at] ^= 1;
        let Ok(changed) = ProofFile::read(&changed) else { continue };
        let audit = on_trust(&changed);
        assert!(!audit.is_replayed() && audit.text().contains("its sum is another"), "byte {at}: {}", audit.text());
        let audit = on_trust(&with_its_sum(changed));
        if audit.is_replayed() {
            // Other steps to the same claim, or another claim that is true: it is told in words.
            assert!(audit.text().contains("For every motion"), "byte {at}: {}", audit.text());
            otherwise += 1;
        } else {
            assert!(audit.text().contains("refused"), "byte {at}: {}", audit.text());
            refused += 1;
        }
    }
    assert!(refused > otherwise && otherwise > 0, "{refused} refused, {otherwise} told");
}

/// A proof that is one, under the name of another claim or with another sequent, is not what the derivation file asks.
#[test]
fn what_is_proved_is_what_the_derivation_file_asks() {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/pendulum.toml")).expect("a file");
    let session = Session::of(parse(Source { path: "pendulum.toml".into(), text }, "pendulum").expect("a derivation"));
    let found = session.check(&Ask::default(), &|_, _| {}).expect("it is checked");
    let file: ProofFile =
        serde_json::from_str(&rederive::report::proofs(found.derivation(), found.account())).expect("proofs");
    assert!(file.proofs.len() > 1, "{}", file.proofs.len());
    let stated = |of: &RecordedClaim| match session.asks_for(of) {
        true => Provenance::AsInFile,
        false => Provenance::Otherwise,
    };
    let right = rederive::report::audit(&file, &stated);
    assert!(right.is_replayed() && right.text().contains("written anew from the derivation file"), "{}", right.text());
    for at in 0..file.proofs.len() {
        let mut renamed = file.clone();
        renamed.proofs[at].claim = file.proofs[(at + 1) % file.proofs.len()].claim.clone();
        let mut fewer = file.clone();
        fewer.proofs[at].proof.relations.pop();
        let mut more = file.clone();
        let claim = more.proofs[at].proof.sequent.claim.clone();
        more.proofs[at].proof.sequent.premises.push(claim);
        for mut changed in [renamed, fewer, more] {
            changed.sum = changed.right_sum();
            let audit = rederive::report::audit(&changed, &stated);
            assert!(!audit.is_replayed() && audit.text().contains("asks something else"), "{at}: {}", audit.text());
        }
    }
}

/// A file in which every claim is false on some motion, or of some numbers.
const FALSE: &str = r#"
[derivation]
title = "false"
concerns = "what no proof may show"
[symbols]
't' = { role = "time" }
's' = { role = "coordinate" }
'x' = { role = "state" }
'y' = { role = "state" }
'z' = { role = "state" }
'a' = { role = "parameter" }
'b' = { role = "parameter" }
'p' = { role = "parameter", positive = true }
'\varphi' = { role = "observable", angle = true, formula = '\operatorname{atan2}(y,x)' }
'\vartheta' = { role = "observable", angle = true, formula = '\operatorname{atan2}(\sqrt{x^2+y^2},z)' }
'q' = { role = "observable", formula = 'x+y' }
'u(s,t)' = { role = "field" }
'v(s,t)' = { role = "field" }
[system.turn]
states = ['x', 'y']
equations = ['\dot x=-y', '\dot y=x']
[system.free]
states = ['z']
equations = ['\dot z=z']
[system.flow]
fields = ['u']
equations = ['\frac{\partial u}{\partial t}=0']
[[claim]]
id = "given"
says = "a relation of a higher degree"
assuming = ['x>1']
always = ['x^2+y^2=1']
[[claim]]
id = "under"
says = "what an assumption brings at all times"
assuming = ['x=2']
always = ['y=3']
[[claim]]
id = "integral"
says = "a number that does not change"
first-integral = ['x']
[[claim]]
id = "product"
says = "what holds where a number is not 0"
assuming = ['z\ne0']
always = ['xz=z']
"#;

/// Whether steps are found of a claim, which leave no case out and presuppose nothing.
fn is_recorded(claim: &str) -> bool {
    let text = format!("{FALSE}\n[[claim]]\nid='c'\nsays='c'\n{claim}\n");
    let session =
        rederive::Session::open("false.toml", text).unwrap_or_else(|problems| panic!("{claim}: {problems:?}"));
    let derivation = session.derivation();
    let claim = derivation.claim("c", None).expect("the claim");
    let found = tactics::Asked::of(derivation, claim, &[tactics::May::Presuppose, tactics::May::EndWithAssumptions])
        .and_then(|asked| asked.record())
        .map(|proof| rederive::findings::Recorded::of(Ok(proof)));
    found.is_ok_and(|recorded| {
        let as_claimed = recorded.presupposed().is_empty() && recorded.throughout().is_empty();
        recorded.steps().is_some() && recorded.left_out() == 0 && as_claimed
    })
}

#[test]
fn no_steps_are_found_for_what_is_false() {
    for claim in [
        r"always=['\sqrt{x^2}=x']",
        r"always=['\sqrt{1-\sin^2x}=\cos x']",
        r"always=['\sqrt{a^2b}=a\sqrt b']",
        r"always=['\cos x=\cos 2x']",
        r"always=['\sin\frac x2\cos\frac x2=\sin x']",
        r"always=['|x+y|=|x|+|y|']",
        r"always=['e^{x+y}=e^x+e^y']",
        // Whole turns lie between an angle and its formula; a sine has no inverse.
        "follows-from=['turn']\nalways=['\\varphi=\\operatorname{atan2}(y,x)']",
        "follows-from=['turn']\nalways=['\\dot\\varphi=0']",
        "follows-from=['turn']\nalways=['\\varphi=\\varphi(0)']",
        "follows-from=['turn']\nalways=['\\varphi=\\varphi(0)+2t']",
        "follows-from=['turn']\nalways=['x^2+y^2=1']",
        // What is given at some times, or under an assumption.
        "follows-from=['given']\nalways=['x^2+y^2=1']",
        "follows-from=['given']\nalways=['x\\dot x+y\\dot y=0']",
        "assuming=['x^2=y^2']\nalways=['x=y']",
        "assuming=['xy=0','xz=0']\nalways=['yz=0']",
        "assuming=['x^2+y^2=0']\nalways=['x=1']",
        "assuming=['x^2=1','y^2=1']\nalways=['xy=1']",
        "assuming=['x\\ge1','z=2']\nalways=['\\dot z=0']",
        // A polar angle is its formula, which moves, has a kink, and is no other one.
        "follows-from=['turn','free']\nalways=['\\dot\\vartheta=0']",
        "follows-from=['turn','free']\nalways=['\\vartheta=\\vartheta(0)']",
        "follows-from=['turn']\nalways=['\\sin\\vartheta=1']",
        "follows-from=['turn']\nalways=['\\vartheta=\\operatorname{atan2}(-\\sqrt{x^2+y^2},z)']",
        "assuming=['x^2+y^2=1']\nalways=['\\sin\\vartheta=1']",
        "assuming=['x^2+y^2+z^2=2']\nalways=['\\cos\\vartheta=z']",
        // Sums of multiples, and what stands before them: a factor must not be 0.
        "assuming=['ax=0','b\\ne0']\nalways=['x=0']",
        "assuming=['x(x-1)=0','x\\ne1']\nalways=['x=1']",
        "assuming=['x^2y=0','y^2z=0']\nalways=['xyz=0','xz=0']",
        "assuming=['x^2+y^2=1','x^3=x']\nalways=['x=0']",
        "assuming=['x^2=y','y^2=z']\nalways=['x^2=z']",
        // What is assumed at some times is not assumed at all of them.
        "follows-from=['under']\nassuming=['x=2','z>1']\nalways=['y=3']",
        "follows-from=['under']\nassuming=['x=2','\\ln z=1']\nalways=['y=3']",
        "follows-from=['under','integral']\nassuming=['x>1']\nalways=['y=3']",
        "follows-from=['under','integral']\nassuming=['x=x','z>1']\nalways=['y=3']",
        "follows-from=['product']\nalways=['x=1']",
        "follows-from=['product']\nassuming=['x\\ne0']\nalways=['x=1']",
        // What is conserved is carried, and nothing else.
        "follows-from=['turn']\nalways=['q=q(0)']",
        "follows-from=['turn','free']\nalways=['xq=x(0)q(0)']",
        "follows-from=['integral']\nalways=['x=0']",
        "follows-from=['integral']\nfirst-integral=['y']",
        "always=['\\cos(0x)=x']",
        "always=['e^{0x}=0']",
        // Signs of products and of sums of squares, and what is 0 somewhere.
        "always=['a^2+b^2>2ab']",
        "always=['a^2\\ge a']",
        "always=['|a|>0']",
        "always=['\\left|2a-1\\right|>1']",
        "assuming=['ab>0']\nalways=['a>0']",
        "assuming=['a>b']\nalways=['a^2>b^2']",
        "assuming=['a\\ne b','ab>0']\nalways=['a^2+b^2>3ab']",
        "assuming=['a>0']\nalways=['\\frac{b}{a}>0']",
        // One sign or the other, and neither.
        "assuming=['x^2=y^2']\nalways=['x=\\pm2y']\nbranches='pointwise'",
        "assuming=['x^2=y^2']\nalways=['x=\\pm y','z=\\pm y']\nbranches='pointwise'",
        "assuming=['x^2=y^2']\nalways=['x=\\pm y']\nbranches='throughout'",
        "always=['\\sqrt{x^2}=\\pm y']\nbranches='pointwise'",
        // Logarithms of sums, and exponentials of parts of them.
        "always=['\\ln(a+p)=\\ln a+\\ln p']",
        "always=['\\ln(a^2p)=\\ln a+2\\ln p']",
        "always=['e^{\\frac12\\ln p}=p']",
        "always=['\\cosh(\\ln p)=p']",
        "always=['\\sin(\\arctan x)=\\cos(\\arctan x)']",
        "always=['\\sin(2\\arctan x)=\\frac{x}{1+x^2}']",
        // Solutions with another start, another equation, and of what moves freely.
        "follows-from=['turn']\nalways=['x=\\cos t']",
        "follows-from=['turn']\nassuming=['x(0)=1','y(0)=1']\nalways=['x=\\cos t']",
        "follows-from=['turn']\nassuming=['x(0)=1','y(0)=0']\nalways=['x=\\cos2t']",
        "follows-from=['turn']\nassuming=['z(0)=0']\nalways=['z=0']",
        // A field is no function of the time alone.
        "follows-from=['flow']\nalways=['u=0']",
        "follows-from=['flow']\nalways=['\\frac{\\partial u}{\\partial s}=0']",
        "follows-from=['flow']\nalways=['\\frac{\\partial^2u}{\\partial s^2}=\\frac{\\partial u}{\\partial s}']",
        "assuming=['s\\le0','u=v']\nalways=['\\frac{\\partial u}{\\partial s}=\\frac{\\partial v}{\\partial s}']",
    ] {
        assert!(!is_recorded(claim), "{claim}");
    }
}

#[test]
fn steps_are_found_for_fields_angles_and_relations() {
    for claim in [
        "follows-from=['turn']\nalways=['x\\sin\\varphi=y\\cos\\varphi']",
        "follows-from=['turn']\nalways=['\\dot\\varphi=1']",
        "follows-from=['turn']\nfirst-integral=['x^2+y^2']",
        "follows-from=['flow']\nalways=['\\frac{\\partial^2u}{\\partial s\\partial t}=0']",
        "assuming=['u=\\frac{\\partial v}{\\partial s}']\nalways=['\\frac{\\partial u}{\\partial t}=\\frac{\\partial^2v}{\\partial s\\partial t}']",
        "assuming=['x^2+y^2=1','xy=0']\nalways=['(x+y)^2=1']",
        "assuming=['ax=0','a\\ne0']\nalways=['x=0']",
        "assuming=['x(x-1)=0','x\\ne0']\nalways=['x=1']",
        "assuming=['x^2=y','y^2=z','z^2=x']\nalways=['x^8=x']",
        "assuming=['x^2+y^2+z^2=1','x\\ne0']\nalways=['\\cos\\vartheta=z','\\sin^2\\vartheta=x^2+y^2']",
        "follows-from=['under','integral']\nassuming=['x=2','z>1']\nalways=['y=3']",
        "follows-from=['under']\nassuming=['x=2','a>1']\nalways=['y=3']",
        "follows-from=['integral']\nfirst-integral=['x']",
        "follows-from=['integral']\nalways=['x(0)=x']",
        "always=['\\cos(0x)=1']",
        "always=['a^2+b^2\\ge2ab','a^2+b^2+x^2\\ge ab+bx+xa','|x|\\ge0','x^2+1>0']",
        "assuming=['a>b','a>0']\nalways=['a^2>ab','a^3>a^2b']",
        "assuming=['a<b','b<0','a<0']\nalways=['\\frac1a>\\frac1b']",
        "assuming=['x^2=y^2']\nalways=['x=\\pm y']\nbranches='pointwise'",
        "always=['\\ln(p^2\\cdot2p)=3\\ln p+\\ln2','\\cosh(\\tfrac12\\ln p)=\\frac{1+p}{2\\sqrt p}']",
        "always=['\\sin(2\\arctan x)=\\frac{2x}{1+x^2}']",
        "follows-from=['turn']\nassuming=['x(0)=1','y(0)=0']\nalways=['x=\\cos t','y=\\sin t']",
        "always=['\\cos 3x=4\\cos^3x-3\\cos x']",
        "always=['\\sqrt{p^2+p^2x^2}=p\\sqrt{1+x^2}']",
    ] {
        assert!(is_recorded(claim), "{claim}");
    }
}

/// Polynomials in x, y, z with small coefficients, in LaTeX, and their values at a point.
struct Polynomials {
    state: u64,
    point: [i64; 3],
}

impl Polynomials {
    fn below(&mut self, n: u64) -> u64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        self.state % n
    }

    /// A polynomial of some terms, and its value.
    fn polynomial(&mut self) -> (String, i64) {
        let (mut text, mut value) = (String::new(), 0);
        for _ in 0..=self.below(3) {
            let factor = [-2, -1, 1, 2, 3][self.below(5) as usize];
            let (mut term, mut product) = (format!("{factor:+}"), factor);
            for (name, at) in ["x", "y", "z"].into_iter().zip(self.point) {
                let power = self.below(3) as u32;
                product *= at.pow(power);
                term += &[String::new(), name.to_owned(), format!("{name}^2")][power as usize];
            }
            value += product;
            text += &term;
        }
        (text, value)
    }
}

/// Assumptions that are true at a point, and a claim that is false there: no steps show it, with whatever factor that is not 0 there.
#[test]
fn no_steps_are_found_against_a_point() {
    let mut random = Polynomials { state: 0x9E37_79B9_7F4A_7C15, point: [0; 3] };
    let (mut asked, mut found_true) = (0, 0);
    for _ in 0..150 {
        random.point = std::array::from_fn(|_| random.below(5) as i64 - 2);
        let mut assumed = Vec::new();
        for _ in 0..2 + random.below(2) {
            let (p, value) = random.polynomial();
            assumed.push(format!("'{p}={value}'"));
        }
        let (factor, value) = random.polynomial();
        if value != 0 {
            assumed.push(format!(r"'{factor}\ne0'").replace(r"\\", r"\"));
        }
        let (p, value) = random.polynomial();
        asked += 1;
        let claim = format!("assuming=[{}]\nalways=['{p}={}']", assumed.join(","), value + 1);
        assert!(!is_recorded(&claim), "{claim} at {:?}", random.point);
        // A product with an assumption is shown.
        let (first, at) = assumed[0].trim_matches('\'').split_once('=').expect("an equation");
        let claim = format!("assuming=[{}]\nalways=['({first})({p})={at}({p})']", assumed.join(","));
        found_true += u32::from(is_recorded(&claim));
    }
    assert!(asked == 150 && found_true >= 140, "{found_true} of {asked}");
}
