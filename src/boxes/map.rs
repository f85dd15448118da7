//! The picture of two ranges: which part of the claim is known where.
//!
//! The ranges are a board of 2ⁿ × 2ⁿ squares. A square that several cells share shows the strongest of what is known there:
//! refuted before undecided before proved before not applicable. With more than two ranges a square stands for all values
//! of the others, so that *refuted* means "for some of them".

use crate::findings::region::{Part, Patch, RegionMap};

use super::subdivide::{Division, PICTURE_BISECTIONS};

fn rank(part: Part) -> u8 {
    match part {
        Part::NotApplicable => 1,
        Part::Proved => 2,
        Part::Border => 3,
        Part::Undecided => 4,
        Part::Refuted => 5,
    }
}

/// The picture of the first two ranges; `None` where there are fewer, or where it would be of one part only.
pub(super) fn draw(division: &Division) -> Option<RegionMap> {
    let n = 1usize << PICTURE_BISECTIONS;
    let mut board = vec![(0u8, Part::Undecided); n * n];
    for piece in &division.pieces {
        let [across, up, ..] = piece.place[..] else { return None };
        // The squares from the first to the one after the last.
        let span = |(bisections, place): (u32, u64)| match PICTURE_BISECTIONS.checked_sub(bisections) {
            Some(finer) => ((place as usize) << finer, (place as usize + 1) << finer),
            None => {
                let at = (place >> (bisections - PICTURE_BISECTIONS)) as usize;
                (at, at + 1)
            }
        };
        let ((left, right), (low, high)) = (span(across), span(up));
        for row in low..high {
            for square in &mut board[row * n + left..row * n + right] {
                if rank(piece.part) > square.0 {
                    *square = (rank(piece.part), piece.part);
                }
            }
        }
    }
    // Runs of equal squares in a row, joined with the same run in the row below.
    let mut patches: Vec<Patch> = Vec::new();
    for row in 0..n {
        let mut column = 0;
        while column < n {
            let part = board[row * n + column].1;
            let width = (column..n).take_while(|c| board[row * n + c].1 == part).count();
            let here = Patch { part, column: column as u32, row: row as u32, width: width as u32, height: 1 };
            let below = patches.iter_mut().rev().take(2 * n).find(|p| {
                p.part == part && p.column == here.column && p.width == here.width && p.row + p.height == here.row
            });
            match below {
                Some(patch) => patch.height += 1,
                None => patches.push(here),
            }
            column += width;
        }
    }
    if patches.len() < 2 {
        return None;
    }
    Some(RegionMap { axes: (0, 1), squares: n as u32, patches })
}
