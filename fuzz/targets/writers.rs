//! Writers: whatever a stranger wrote into the texts of a file, no format has a character that acts, and each is what it is.
#![no_main]

use std::cell::RefCell;

use libfuzzer_sys::fuzz_target;
use rederive::check::{Account, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, escape};
use rederive::report;

const FILE: &str = r#"
[derivation]
title = "t"
concerns = "c"
[symbols]
't' = { role = "time" }
'x' = { role = "state" }
[system.s]
states = ['x']
equations = ['\dot x=-x']
[[trajectory]]
id = "a"
system = "s"
initial = { 'x' = 1 }
span = [0, 1]
[[claim]]
id = "law"
says = "s"
always = ['\dot x=-x']
[[claim]]
id = "wrong"
says = "w"
always = ['x=1']
"#;

fn checked() -> (Derivation, Account) {
    let derivation = parse(Source { path: "fuzz.toml".into(), text: FILE.into() }, "fuzz").expect("it loads");
    let account = check(&derivation, &Options::default(), &|_, _| {}).expect("it is checked");
    (derivation, account)
}

thread_local! {
    static CHECKED: RefCell<(Derivation, Account)> = RefCell::new(checked());
}

fuzz_target!(|text: &str| {
    CHECKED.with_borrow_mut(|(derivation, account)| {
        // As the loader leaves a text; `tests/hostile.rs` sees to it that it does.
        let text = escape::shown(text.trim()).into_owned();
        derivation.title.clone_from(&text);
        derivation.concerns.clone_from(&text);
        derivation.remark = Some(text.clone());
        derivation.conventions = vec![(escape::in_one_line(&text), text.clone())];
        for claim in &mut derivation.claims {
            claim.says.clone_from(&text);
        }
        for claim in &mut account.claims {
            claim.says.clone_from(&text);
            claim.remark = Some(text.clone());
            claim.place = Some(text.clone());
        }
        let json = report::json(derivation, account);
        let page = report::page(derivation, account);
        let tex = report::tex(derivation, account);
        let markdown = report::markdown(derivation, account);
        let said = report::summary(derivation, account, false, true);
        for out in [&json, &page, &tex, &markdown, &said] {
            assert!(out.chars().all(|c| !c.is_control() || "\n\t".contains(c)));
        }
        let findings = report::findings(derivation, account);
        for line in report::github(&findings).lines() {
            assert!(line.starts_with("::error ") || line.starts_with("::warning "), "{line}");
        }
        assert_eq!(tex.matches("\\end{document}").count(), 1);
        assert_eq!(page.matches("<script").count(), page.matches("</script>").count());
        assert!(report::certificates(derivation, account).iter().all(|(_, t)| t.is_ascii() || !t.contains('\u{202e}')));
    });
});
