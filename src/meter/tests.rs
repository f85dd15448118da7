use super::*;

/// Counts so many thousand units.
fn count(units: u64) -> u64 {
    (0..units).map(|_| charge(1_000)).count() as u64
}

#[test]
fn a_piece_ends_where_its_work_is_used_up() {
    let within = |limits: &Limits, work: u64| {
        let mut done = 0;
        let found = piece(Task::Reading, limits, || {
            for _ in 0..work {
                charge(1_000_000);
                done += 1;
            }
        });
        (found, done)
    };
    let once = Limits::default();
    assert_eq!(within(&once, 10_000), (Ok(()), 10_000));
    assert_eq!(within(&once, 20_000), (Err(Ended::Work(Task::Reading, WorkFactor::default())), 10_000));
    for (text, done) in [("2", 20_000), ("0.1", 1_000), ("0.0009", 10)] {
        let times: WorkFactor = text.parse().expect("a number");
        let limits = Limits { work: times, ..Limits::default() };
        assert_eq!(within(&limits, 30_000), (Err(Ended::Work(Task::Reading, times)), done));
    }
    for text in ["0", "-1", "1e-4", "1000001", "NaN", "inf", "many", ""] {
        assert!(text.parse::<WorkFactor>().is_err(), "{text}");
    }
}

#[test]
fn what_ends_a_piece_says_how_much_it_was_and_what_would_allow_more() {
    let said = |text: &str, ended: fn(WorkFactor) -> Ended| ended(text.parse().expect("a number")).to_string();
    let work = said("2.5", |times| Ended::Work(Task::Formula, times));
    assert!(work.contains("more than about 2.5 s") && work.contains("--work 25 would"), "{work}");
    let bytes = said("0.01", |times| Ended::Bytes(Task::Formula, times));
    assert!(bytes.contains("more than 0.64 MB") && bytes.contains("--work 0.1 would"), "{bytes}");
    let file = said("1", |times| Ended::File(Task::Proving, times));
    assert!(
        file.contains("about 33 s") && file.contains("and proving a claim comes") && file.contains("--work 10 would")
    );
}

#[test]
fn what_only_grows_is_counted() {
    let found = piece(Task::Reading, &Limits::default(), || (0..600).for_each(|_| grow(MEGABYTE)));
    assert_eq!(found, Err(Ended::Bytes(Task::Reading, WorkFactor::default())));
    assert_eq!(piece(Task::Reading, &Limits::default(), || (0..500).for_each(|_| grow(MEGABYTE))), Ok(()));
}

#[test]
fn a_piece_takes_nothing_else_with_it() {
    let limits = Limits::default();
    let outer = piece(Task::Proving, &limits, || {
        let inner = piece(Task::Reading, &limits, || charge(u64::MAX));
        assert_eq!(inner, Err(Ended::Work(Task::Reading, WorkFactor::default())));
        count(10)
    });
    assert_eq!(outer, Ok(10));
    // Outside of pieces nothing ends.
    charge(u64::MAX);
    grow(u64::MAX);
}

#[test]
fn a_panic_is_a_defect_of_its_piece() {
    let before = Defects::so_far();
    let found: Result<(), Ended> = piece(Task::Reading, &Limits::default(), || resume_unwind(Box::new("on purpose")));
    let Err(Ended::Defect(what)) = found else { panic!("a defect") };
    assert!(what.contains("on purpose"), "{what}");
    assert_eq!(before.since(), Some(what));
    assert_eq!(Defects::so_far().since(), None);
}

#[test]
fn the_machine_is_looked_at_inside_of_a_piece() {
    let flag = Cancel::default();
    let limits = Limits { cancel: Some(flag.clone()), ..Limits::default() };
    let found = piece(Task::Proving, &limits, || {
        for k in 0_u64.. {
            charge(SLICE / 4);
            if k == 10 {
                flag.raise();
            }
            assert!(k < 20, "it goes on");
        }
    });
    assert_eq!(found, Err(Ended::Cancelled));
    let past = Limits { deadline: Some(Instant::now()), ..Limits::default() };
    assert_eq!(piece(Task::Proving, &past, || charge(1)), Err(Ended::Time));
}

#[test]
fn a_limit_of_the_machine_is_reached_when_it_is() {
    assert_eq!(Limits::default().reached(), None);
    let past = Limits { deadline: Some(Instant::now()), ..Limits::default() };
    assert_eq!(past.reached(), Some(Ended::Time));
    let later = Limits { deadline: Limits::after(Some(3600.0)), ..Limits::default() };
    assert!(later.deadline.is_some() && later.reached().is_none());
    assert_eq!([None, Some(-1.0), Some(f64::NAN), Some(f64::MAX)].map(Limits::after), [None; 4]);
    let flag = Cancel::default();
    let ended = Limits { cancel: Some(flag.clone()), ..Limits::default() };
    assert!(!ended.is_cancelled() && ended.reached().is_none());
    flag.raise();
    assert!(ended.is_cancelled() && ended.reached() == Some(Ended::Cancelled));
    assert_ne!(flag, Cancel::default());
    if cfg!(target_os = "linux") {
        assert!(resident().is_some_and(|bytes| bytes > 1 << 20));
        assert_eq!(Limits { memory: Some(1), ..Limits::default() }.reached(), Some(Ended::Memory));
        assert_eq!(Limits { memory: Some(1 << 50), ..Limits::default() }.reached(), None);
    }
}

#[test]
fn a_part_is_counted_with_its_piece() {
    let limits = Limits::default();
    let parts = Cell::new(0);
    let found: Result<(), Ended> = piece(Task::Reading, &limits, || {
        loop {
            let part = part(Task::Formula, || (0..900).for_each(|_| charge(1_000_000)));
            match part {
                Ok(()) => parts.set(parts.get() + 1),
                // What it used is gone for the piece, too.
                Err(_) => charge(SECOND),
            }
        }
    });
    // Eleven of 0.9 s within 10 s; the last one ends, and so does what comes after it.
    assert_eq!((found, parts.get()), (Err(Ended::Work(Task::Reading, WorkFactor::default())), 11));
    let alone = part(Task::Formula, || charge(2 * SECOND));
    assert_eq!(alone, Err(Ended::Work(Task::Formula, WorkFactor::default())));
    let ten = Limits { work: "10".parse().expect("a number"), ..Limits::default() };
    assert_eq!(under(&ten, || part(Task::Formula, || charge(2 * SECOND))), Ok(Ok(())));
}

#[test]
fn what_is_counted_apart_is_charged_by_hand() {
    let found = piece(Task::Formula, &Limits::default(), || {
        let of = |most: u64| {
            apart(&limits(), most, || {
                charge(3 * SECOND);
                charge(7);
                "done"
            })
        };
        assert_eq!(of(4 * SECOND), (Some("done"), 3 * SECOND + 7));
        assert_eq!(of(2 * SECOND), (None, 2 * SECOND));
        charge(SECOND / 2);
    });
    assert_eq!(found, Ok(()));
}

#[test]
fn the_page_of_limits_has_the_table() {
    let page = include_str!("../../docs/limits.md");
    for task in Task::ALL {
        let (words, units, bytes) = (task.words(), task.units() / SECOND, task.bytes() / MEGABYTE);
        let row = format!("\n| {words} | {units} | {bytes} |\n");
        assert!(page.contains(&row), "docs/limits.md has no row `{}`", row.trim());
    }
    let rows =
        page.lines().filter(|line| Task::ALL.iter().any(|task| line.starts_with(&format!("| {} |", task.words()))));
    assert_eq!(rows.count(), Task::ALL.len());
    let whole = format!("All pieces of a file together take at most {},", total::OF_A_FILE / SECOND);
    assert!(page.contains(&whole), "docs/limits.md does not say `{whole}`");
}
