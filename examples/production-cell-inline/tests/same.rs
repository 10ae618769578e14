//! However a specification is given, the controller is the same.

mod from_file {
    sml_macros::sml!("../production-cell/specs/production_cell.sml");
}

use from_file::production_cell as other;
use production_cell_inline::production_cell as inline;

const EVENTS: [(inline::Event, other::Event); 10] = {
    use inline::Event as A;
    use other::Event as B;
    [
        (A::DepositArmControllerArrivedAtDepositBelt, B::DepositArmControllerArrivedAtDepositBelt),
        (A::DepositArmControllerArrivedAtPress, B::DepositArmControllerArrivedAtPress),
        (A::DepositArmControllerPickedUpItem, B::DepositArmControllerPickedUpItem),
        (A::DepositArmControllerReleasedItem, B::DepositArmControllerReleasedItem),
        (A::FeedArmControllerArrivedAtFeedBelt, B::FeedArmControllerArrivedAtFeedBelt),
        (A::FeedArmControllerArrivedAtPress, B::FeedArmControllerArrivedAtPress),
        (A::FeedArmControllerPickedUpItem, B::FeedArmControllerPickedUpItem),
        (A::FeedArmControllerReleasedItem, B::FeedArmControllerReleasedItem),
        (A::FeedBeltControllerBlankArrived, B::FeedBeltControllerBlankArrived),
        (A::PressControllerPressingFinished, B::PressControllerPressingFinished),
    ]
};

#[test]
fn inline_and_file_agree_cycle_for_cycle() {
    let (mut a, mut b) = (inline::Controller::new(), other::Controller::new());
    let mut random = 1_u64;
    let mut commanded = 0;
    for _ in 0..20_000 {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        for (index, (event, twin)) in EVENTS.into_iter().enumerate() {
            if random >> (8 + index) & 3 == 0 {
                assert_eq!(a.raise(event), b.raise(twin));
            }
        }
        let (x, y) = (a.cycle(), b.cycle());
        commanded += usize::from(!x.is_empty());
        assert_eq!(format!("{x:?}"), format!("{y:?}"));
        assert_eq!(a.state(), b.state());
        // What stays pending would soon be everything.
        if random >> 40 & 15 == 0 {
            a.reset();
            b.reset();
        }
    }
    assert!(commanded > 1000, "only {commanded} cycles issued commands");
}
