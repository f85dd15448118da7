//! The fewest motions that reject everything that any of them rejects.

/// Most sets that are looked at before the search gives up being exact.
const MOST_STEPS: usize = 200_000;

/// Positions of the fewest sets whose union is that of all, and whether there is certainly no smaller choice.
///
/// First greedily: the set with the most new members, the earliest among equals. Then a search by depth for a smaller one, up
/// to a fixed number of steps.
pub(super) fn least_cover(sets: &[Vec<bool>]) -> (Vec<usize>, bool) {
    let size = sets.iter().map(Vec::len).max().unwrap_or(0);
    let words = size.div_ceil(64);
    let packed = |set: &Vec<bool>| {
        let mut bits = vec![0u64; words];
        for (i, _) in set.iter().enumerate().filter(|(_, b)| **b) {
            bits[i / 64] |= 1 << (i % 64);
        }
        bits
    };
    let packed: Vec<Vec<u64>> = sets.iter().map(packed).collect();
    let mut all = vec![0u64; words];
    for set in &packed {
        all.iter_mut().zip(set).for_each(|(a, b)| *a |= b);
    }
    let mut chosen = Vec::new();
    let mut left = all.clone();
    let gain = |set: &[u64], left: &[u64]| -> u32 { set.iter().zip(left).map(|(a, b)| (a & b).count_ones()).sum() };
    while left.iter().any(|w| *w != 0) {
        let best = (0..packed.len()).max_by_key(|&i| (gain(&packed[i], &left), std::cmp::Reverse(i)));
        let Some(best) = best else { break };
        chosen.push(best);
        left.iter_mut().zip(&packed[best]).for_each(|(l, s)| *l &= !s);
    }
    chosen.sort_unstable();
    let mut steps = 0;
    while chosen.len() > 1 {
        let mut found = Vec::new();
        match deeper(&packed, &all, chosen.len() - 1, &mut found, &mut steps) {
            Some(true) => chosen = found,
            Some(false) => return (chosen, true),
            None => return (chosen, false),
        }
        chosen.sort_unstable();
    }
    (chosen, true)
}

/// Whether `depth` sets cover what is left; `None` when the search is given up.
fn deeper(sets: &[Vec<u64>], left: &[u64], depth: usize, found: &mut Vec<usize>, steps: &mut usize) -> Option<bool> {
    // The first member that is left must be in one of the sets: only these are tried.
    let Some(word) = left.iter().position(|w| *w != 0) else { return Some(true) };
    if depth == 0 {
        return Some(false);
    }
    let bit = left[word] & left[word].wrapping_neg();
    for (i, set) in sets.iter().enumerate().filter(|(_, s)| s[word] & bit != 0) {
        *steps += 1;
        if *steps > MOST_STEPS {
            return None;
        }
        let rest: Vec<u64> = left.iter().zip(set).map(|(l, s)| l & !s).collect();
        found.push(i);
        if deeper(sets, &rest, depth - 1, found, steps)? {
            return Some(true);
        }
        found.pop();
    }
    Some(false)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sets(rows: &[&str]) -> Vec<Vec<bool>> {
        rows.iter().map(|r| r.chars().map(|c| c == '1').collect()).collect()
    }

    #[test]
    fn the_least_is_found_where_greed_takes_more() {
        // Greed takes the large one first and then needs two more.
        let rows = sets(&["0111100", "1110000", "0001111"]);
        assert_eq!(least_cover(&rows), (vec![1, 2], true));
    }

    #[test]
    fn nothing_to_cover_needs_nothing() {
        assert_eq!(least_cover(&sets(&["000", "000"])), (vec![], true));
        assert_eq!(least_cover(&[]), (vec![], true));
        assert_eq!(least_cover(&sets(&["000", "101", "100"])), (vec![1], true));
    }
}
