//! Names in derivatives: what is derived, and by what.

use super::letters::FRACTIONS;
use super::{By, Names, PaperName, plain};

impl Names {
    /// `\frac{dx}{dt}`, `\frac{d}{dt}`, or a fraction of anything.
    pub(super) fn fraction(&mut self, at: usize, to: usize, by: &By, depth: usize) -> usize {
        let (top, middle) = (at + 1, self.unit(at + 1));
        let end = self.unit(middle).min(to);
        let differential = |text: &str| matches!(text, "d" | r"\partial" | r"\mathrm" | r"\dd");
        let first = self.inner(top).0;
        // `{dx}^2` prints what `dx^2` does.
        let below = self.inner(middle).0;
        let below = if self.text(below) == "{" { below + 1 } else { below };
        let begins =
            differential(self.text(first)) && differential(self.text(below)) && self.text(below) == self.text(first);
        if !begins {
            self.range(top, middle, by, depth + 1);
            self.range(middle, end, by, depth + 1);
            return end;
        }
        let partial = self.text(first) == r"\partial";
        let skip = |names: &Names, at: usize| match names.text(at) {
            r"\mathrm" => names.unit(at + 1),
            _ => at + 1,
        };
        let mut next = skip(self, below);
        let mut variables = Vec::new();
        while next < end {
            match self.variable(next) {
                Some((variable, after)) => {
                    variables.push(variable);
                    next = after;
                }
                None if self.text(next) == "^" => next = self.unit(next + 1),
                None => next += 1,
            }
            if differential(self.text(next)) {
                next = skip(self, next);
            }
        }
        let by = variables.first().map(|v| (v.clone(), partial)).or_else(|| by.clone());
        let mut over = skip(self, first);
        if self.text(over) == "^" {
            over = self.unit(over + 1);
        }
        let before = self.out.len();
        self.derived(over, middle, &by, depth + 1);
        if self.out.len() == before {
            // What follows the operator is derived: the next factor, a group or a name.
            let stop = self.factor(end, to);
            self.derived(end, stop, &by, depth + 1);
            self.note_variables(&variables);
            return stop.max(end);
        }
        self.note_variables(&variables);
        end
    }

    /// `dx/dt`, in one line.
    pub(super) fn slashed(&mut self, at: usize, to: usize, depth: usize) -> Option<usize> {
        let over = self.differential(at)?;
        let (_, middle) = self.variable(over)?;
        let below = self.differential(middle + 1).filter(|_| self.text(middle) == "/")?;
        let (variable, end) = self.variable(below).filter(|(_, end)| *end <= to)?;
        self.derived(over, middle, &Some((variable.clone(), false)), depth + 1);
        self.note_variables(&[variable]);
        Some(end)
    }

    /// The position after a `d`, italic or upright.
    fn differential(&self, at: usize) -> Option<usize> {
        match self.text(at) {
            "d" => Some(at + 1),
            r"\mathrm" if self.text(self.inner(at + 1).0) == "d" && self.unit(at + 1) <= at + 4 => {
                Some(self.unit(at + 1))
            }
            _ => None,
        }
    }

    /// The position after a factor: a group, a fraction, or a name.
    fn factor(&self, at: usize, to: usize) -> usize {
        match self.text(at) {
            "(" | "[" | "{" => self.closing(at, to),
            text if text.starts_with(r"\begin ") => self.environment_end(at, to).min(to),
            r"\left" | r"\qty" | r"\bigl" | r"\Bigl" | r"\big" | r"\Big" if at + 1 < to => self.factor(at + 1, to),
            text if text.strip_prefix('\\').is_some_and(latex::is_function) && at + 1 < to => {
                let mut next = at + 1;
                while matches!(self.text(next), "^" | "_") && next < to {
                    next = self.unit(next + 1);
                }
                self.factor(next, to)
            }
            text if text.strip_prefix('\\').is_some_and(|c| FRACTIONS.contains(&c)) => {
                self.unit(self.unit(at + 1)).min(to)
            }
            _ => {
                // A name with what stands above and below it.
                let mut next = self.script_end(at);
                while matches!(self.text(next), "_" | "^" | "'") && next < to {
                    next = if self.text(next) == "'" { next + 1 } else { self.script_end(next + 1) };
                }
                next.min(to)
            }
        }
    }

    fn note_variables(&mut self, variables: &[String]) {
        for v in variables {
            self.out.push(PaperName { is_variable: true, ..plain(v) });
        }
    }

    /// What is derived: each entry of a matrix by itself.
    fn derived(&mut self, from: usize, to: usize, by: &By, depth: usize) {
        let mut begin = from;
        for end in (from + 1..to).filter(|at| self.begins_cell(*at)).chain([to]).collect::<Vec<_>>() {
            let before = self.out.len();
            self.range(begin, end, by, depth);
            self.note_group(before);
            begin = end;
        }
    }

    /// The position behind a matrix that begins here, and how many primes stand behind it.
    pub(super) fn primed_matrix(&self, at: usize, to: usize) -> Option<(usize, usize)> {
        let begins = self.text(at).strip_prefix(r"\begin ").is_some_and(|name| name.ends_with("matrix"));
        let end = if begins { self.environment_end(at, to) } else { return None };
        let primes = match self.text(end) {
            "'" => (end..to).take_while(|&i| self.text(i) == "'").count(),
            "^" => self.primes_above(end + 1),
            _ => 0,
        };
        (primes > 0 && end > at + 1).then_some((end, primes))
    }

    /// Primes behind a column of names derive each of them.
    pub(super) fn note_primes(&mut self, from: usize, (begin, end): (usize, usize), primes: usize) {
        let cells = 1 + (begin + 2..end.saturating_sub(1)).filter(|at| self.begins_cell(*at)).count();
        let names = &mut self.out[from..];
        let plain = |n: &PaperName| n.primes + n.dots == 0 && n.call == super::Call::None && n.derived_by.is_none();
        if names.len() == cells && names.iter().all(plain) {
            for name in names {
                name.primes = primes;
                name.base.push_str(&"'".repeat(primes));
            }
        }
    }

    /// The position behind an environment that begins here.
    fn environment_end(&self, at: usize, to: usize) -> usize {
        let mut depth = 0i32;
        let end = (at..to).find(|&i| {
            depth += i32::from(self.text(i).starts_with(r"\begin ")) - i32::from(self.text(i).starts_with(r"\end "));
            depth == 0
        });
        end.map_or(to, |end| end + 1)
    }

    /// Several names that are derived together.
    fn note_group(&mut self, from: usize) {
        if self.out.len() > from + 1 {
            self.out[from..].iter_mut().for_each(|n| n.is_in_group = true);
        }
    }

    /// `\dv{f}{x}`, `\dv{x}`, `\pdv[2]{f}{x}`.
    pub(super) fn physics(&mut self, at: usize, to: usize, partial: bool, depth: usize) -> usize {
        let mut next = at + 1;
        if self.text(next) == "*" {
            next += 1;
        }
        if self.text(next) == "[" {
            next = self.closing(next, to);
        }
        let middle = self.unit(next);
        let has_second = self.text(middle) == "{" || self.variable(middle).is_some();
        if !has_second {
            let end = middle.min(to);
            let variable = self.variable(self.inner(next).0).map(|v| v.0);
            let by = variable.clone().map(|v| (v, partial));
            self.note_variables(&variable.into_iter().collect::<Vec<_>>());
            // What follows the operator is derived: the next factor, a group or a name.
            let stop = self.factor(end, to).max(end);
            self.derived(end, stop, &by, depth + 1);
            return stop;
        }
        let end = self.unit(middle).min(to);
        let variable = self.variable(self.inner(middle).0).map(|v| v.0);
        let by = variable.clone().map(|v| (v, partial));
        self.derived(next, middle, &by, depth + 1);
        self.note_variables(&variable.into_iter().collect::<Vec<_>>());
        end
    }

    /// `\partial_x f`: the letter below, and what follows.
    pub(super) fn partial_letter(&mut self, at: usize, to: usize, depth: usize) -> usize {
        if self.text(at + 1) != "_" {
            return at + 1;
        }
        let end = self.unit(at + 2).min(to);
        let Some((variable, _)) = self.variable(self.inner(at + 2).0) else { return end };
        let mut next = end;
        if self.text(next) == "^" {
            next = self.unit(next + 1);
        }
        let by = Some((variable.clone(), true));
        self.note_variables(std::slice::from_ref(&variable));
        if let Some(after) = self.name(next, to, &by) {
            return after;
        }
        let stop = self.factor(next, to).max(next);
        let before = self.out.len();
        self.range(next, stop, &by, depth + 1);
        self.out[before..].iter_mut().for_each(|n| n.is_in_group = true);
        stop
    }
}
