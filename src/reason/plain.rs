//! Reasons that say all that there is to say: sentences without data.

use serde::{Deserialize, Serialize};

macro_rules! sentences {
    ($($(#[$doc:meta])* $name:ident: $words:literal,)*) => {
        /// A reason without data.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
        pub enum Plain {
            $($(#[$doc])* $name,)*
        }

        impl Plain {
            /// Its words.
            pub fn words(self) -> &'static str {
                match self {
                    $(Plain::$name => $words,)*
                }
            }
        }
    };
}

impl std::fmt::Display for Plain {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.words())
    }
}

sentences! {
    // The kernel.
    WithoutEvidence: "a part of the claim was judged without its evidence",
    CertainBothWays: "two ways to decide it for certain contradict each other",
    NothingToTry: "the claim says nothing that could be tried",
    NoPartDecides: "no part of it decides alone",
    // Limits of a run.
    Cancelled: "the run was cancelled before this was done",
    TimeOver: "work limit: the time of the run was over before this was done",
    MemoryUsedUp: "work limit: the memory of the run was used up before this was done",
    Ended: "the run was ended",
    MembersTried: "work limit: the families of a file try a million members",
    MembersRejected: "work limit: the families of a file reject 100 million members",
    StepsTaken: "work limit: the members of a file's families take 300 million steps",
    MotionsTried: "work limit: as many motions were tried to find it as may be",
    NoVerdict: "it has no verdict",
    ClaimItselfFails: "the claim itself fails",
    // Enclosures.
    NothingCompared: "nothing is compared",
    NoSingleSign: "no single sign of ± serves the whole motion",
    NoSingleSignShown: "no single sign of ± is shown to serve",
    NeverHasValue: "at no time of the span that counts does it have a value",
    NoTimeOfSpanCounts: "no time of the span counts",
    ValueOpen: "whether there is a value cannot be told",
    WhetherTimesCountOpen: "whether any time counts is open",
    WhetherTimesCountUncertain: "whether any time counts is not certain",
    FalseForCertain: "it is false for certain",
    TwoValuesForCertain: "it takes two values for certain",
    ConstantOfOneSign: "what is the same for one sign of ± is not enclosed where the start does not count",
    DoesNotReachSpan: "the enclosure does not reach as far as the span",
    FamilyNotEnclosed: "members of a family are not enclosed",
    NoTimeToShow: "it does not happen, but there is no time to show that counts",
    FormAtEvents: "a claim of this form at events is not enclosed",
    EventOpen: "whether there is an event cannot be told",
    OneEventOpen: "whether there is an event, and one only, cannot be told",
    NoEventCounts: "there is no event in the span that counts",
    CountedEvent: "at the event that is counted",
    OnlyEvent: "at the only event in the span",
    MeantFromAll: "whether it is one of the events that are meant is seen from all of them",
    LimitNotEnclosed: "a limit of this kind is not enclosed",
    IntegratedTail: "an integrated motion is not known for all times; limits at infinity are found for motions given by formulas",
    AssumptionsNotFollowed: "assumptions of this form are not followed to all later times",
    AssumedLaterOpen: "whether the assumptions hold at all later times is not certain",
    IndependentAtEvents: "independence at events is not enclosed",
    MayBeDependent: "the gradients may be dependent",
    NoGradients: "no gradients were computed",
    StartIsNoNumber: "the start is not a number",
    StartNotCounted: "the start is none of the times that are counted",
    StartNoExactEvent: "that the start is an event is not exact",
    StartNotRational: "dependence is shown only where parameters and initial states are rational numbers",
    IndependentAtStart: "the functions are independent at the start",
    MotionsUnderAssumptions: "under assumptions or events that select times, two motions are not compared",
    NoTimeInCommon: "the motions have no time in common",
    // Samples.
    NoTimeKnownToCount: "no time is known to count",
    NoTimeToTry: "no time at which it could be tried",
    NoValueDetermined: "no value could be determined",
    NotLookedAt: "it was not looked at",
    NotTriedWhereUnmet: "it was not tried, since an assumption is not met",
    NotSearched: "what lies between the samples cannot be searched",
    NothingByItself: "nothing is said of it by itself",
    LimitThroughAssumed: "a limit through the times that assumptions leave is not seen from samples",
    NoTimeCounts: "no time counts",
    WhetherTimesCountUntold: "whether any time counts cannot be told",
    NotMeasured: "its values were not measured",
    TooManyPeaks: "an exponential in it has too many peaks that samples may miss",
    MotionHasNoValueThere: "the formulas of the motion have no value there",
    LimitAtInfinity: "a motion of finite length does not tell a limit at infinity; a bound for all later times would",
    NoPointOfLimit: "the point of the limit has no value on this motion",
    RankFallsAtEvent: "the rank falls at the event alone, whose time is not known exactly",
    NoTimeToTryIndependence: "there is no time at which it could be tried",
    NoTimeKnownToCountThere: "there is no time of which it is known that it counts",
    NoGradientAnywhere: "the gradients have no value at any sample",
    MeasureUnknown: "the measure depends on something that motions do not have",
    NothingToShow: "what it shows has no value on this motion",
    // Proofs.
    SaidIsExcluded: "it contradicts what is given, at every time that counts",
    DeniedIsProved: "what it denies is proved to be so wherever it has a value",
    DeniedIsExcluded: "what it denies contradicts what is given, at every time that counts",
    DeniedIsOpen: "what it denies is neither shown to be so always, nor excluded",
    EqualNowhere: "both sides are equal wherever they have values, but no real point was found that satisfies what is given and at which they have some",
    OnlySpecialCases: "it was proved outside of special cases only, and no real point was found outside of them",
    GivenHasNoValue: "what is given makes a formula have no value",
    RefutedWithoutAll: "refuted without something given that could not be used",
    Unreplayed: "the prover finds a proof, which the checker does not replay: it may use what is known at some times at others",
    NoMotionKnown: "no motion is found on which all that is given is so: of what may never be so, everything would follow",
    SignAtOtherTimes: "the sign that is assumed is one with that of the claim, and may be another one at the times that are named",
    SignsUndecided: "the signs of the coefficients do not decide in every order of the parameters",
    TooLargeForProof: "work limit: its formulas, with all that they follow from, are too large for a proof",
    OnlyRates: "it compares values at different times, which what is given connects only through rates: that would need the solution of a differential equation",
    Unconnected: "what is given names values at fixed times; it was not settled which present values a motion reaches from them",
    RefutedWithinErrors: "on the motion that would refute it, what is given holds only as far as numbers show",
    // Ranges of values.
    AtTheOnePoint: "at the one point that is asked for",
    AtEveryPoint: "at every point of the ranges",
    WhereverItApplies: "at every point at which it applies",
    AtNoPoint: "at no point of the ranges do its assumptions hold and its formulas have values",
    PartRefuted: "a part of the ranges is refuted",
    NoPointForCertain: "no point was found at which its assumptions certainly hold",
    NotEverywhere: "it is not decided everywhere",
    NoEquation: "it is no equation that could follow from others",
    NoSolution: "there is no solution",
    RangesWorkLimit: "work limit: taking ranges apart has used its share of the counted work; a larger --work would allow more",
    // Members of a family, side by side.
    EventHasNoMeaning: "the event has no meaning on this motion",
    NoEventOnOther: "the event does not happen on the member that it is compared with",
    ComparedUnknown: "it is not known what is compared",
    NoMemberBeside: "work limit: no member beside it satisfies the constraints",
    OtherRejected: "a motion that it would be compared with does not satisfy the constraints",
    TooNearExtremum: "it lies nearer to the extremum than what is said of it",
    ComparesMembers: "it compares the members of a family",
    NoQuantity: "there is no quantity",
    QuantityUnknown: "the quantity is not known",
    OtherNotBuilt: "the other member was not built",
    NothingToCompare: "there is nothing to compare it with",
    LimitNotOfTwo: "a limit is not told by two members",
    NoSequence: "there is no sequence",
    LimitHasNoValue: "what it is said to tend to has no value",
    LimitChanges: "what it is said to tend to is not the same along the sequence",
    NoSlope: "what varies changes its sign, or vanishes: there is no slope of logarithms",
    NoLogarithm: "the quantity is too near 0, against its error, to have a logarithm",
    LogarithmTooLarge: "a logarithm is too large",
    TooNearOneAnother: "the values of what varies are too near one another",
    RatesOfSystemsDiffer: "the rates in the functions are others for each of the systems: ask for one system at a time",
    FunctionsUnknown: "the functions depend on something that this motion does not have",
    NoStateInCommon: "the motions have no state in common that could be compared",
    NoCommonSample: "no sample at which both motions are known counts; an end of their common span may",
    SequenceUnknown: "the quantity is not known at every member of the sequence",
    StepsDoNotShrink: "the steps of the sequence do not shrink",
    RatiosDoNotSettle: "the steps of the sequence shrink by ratios that do not settle",
}
