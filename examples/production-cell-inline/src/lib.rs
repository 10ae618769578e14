//! The production cell of Gritzner and Greenyer (2018), written in the macro: the module [`production_cell`] is the
//! controller, verified when this crate is compiled.
//!
//! ```
//! use production_cell_inline::production_cell::{Controller, Event, FeedArmCommand};
//!
//! let mut controller = Controller::new();
//! let commands = controller.react(Event::FeedBeltControllerBlankArrived).unwrap();
//! assert_eq!(commands.feed_arm, Some(FeedArmCommand::PickUp));
//! assert_eq!(controller.react(Event::PressControllerPressingFinished), None);
//! ```

sml_macros::sml! {
    // The production cell of Gritzner and Greenyer (2018): G1-G3 as in the paper, the rest from its prose.
    specification ProductionCell {
      domain productioncell {
        abstract class Location { }
        class ConveyorBelt : Location { }
        class Press : Location { hasItem: bool  startPressing() }
        class RobotArm { location: Location  carriesItem: bool  pickUp()  moveTo(target: Location)  releaseItem() }
        class Controller { blankArrived()  pickedUpItem()  arrivedAt(place: Location)  releasedItem()  pressingFinished() }
      }
      object controller: Controller
      object feedBelt: ConveyorBelt
      object depositBelt: ConveyorBelt
      object press: Press
      object feedArm: RobotArm { location: feedBelt }
      object depositArm: RobotArm { location: press }

      effects {
        RobotArm -> Controller.arrivedAt(place) { sender.location = place }
        RobotArm -> Controller.pickedUpItem() { sender.carriesItem = true }
        depositArm -> Controller.pickedUpItem() { press.hasItem = false }
        RobotArm -> Controller.releasedItem() { sender.carriesItem = false }
        feedArm -> Controller.releasedItem() { press.hasItem = true }
      }

      controllable { Controller }
      non-spontaneous events {
        Controller.pickedUpItem Controller.arrivedAt Controller.releasedItem Controller.pressingFinished
      }

      collaboration ProductionCell {
        static role Controller controller
        static role RobotArm feedArm
        static role RobotArm depositArm
        static role Press press
        static role ConveyorBelt feedBelt
        static role ConveyorBelt depositBelt
        dynamic role RobotArm arm

        /// G1: when a blank arrives, the feed arm must pick it up when possible
        guarantee scenario BlankArrives {
          feedBelt -> controller.blankArrived()
          wait [feedArm.location == feedBelt && !feedArm.carriesItem]
          urgent controller -> feedArm.pickUp()
        }
        /// G2: the feed arm carries a picked-up blank to the press and returns
        guarantee scenario ArmDeliversItemToPress {
          feedArm -> controller.pickedUpItem()
          urgent controller -> feedArm.moveTo(press)
          feedArm -> controller.arrivedAt(press)
          wait [!press.hasItem]
          urgent controller -> feedArm.releaseItem()
          feedArm -> controller.releasedItem()
          urgent controller -> feedArm.moveTo(feedBelt)
        }
        /// G3: a released blank is pressed
        guarantee scenario PressStartsPressing {
          feedArm -> controller.releasedItem()
          urgent controller -> press.startPressing()
        }
        /// G4: the deposit arm picks up a pressed item when possible
        guarantee scenario ArmPicksUpPressedItem {
          press -> controller.pressingFinished()
          wait [depositArm.location == press && !depositArm.carriesItem]
          urgent controller -> depositArm.pickUp()
        }
        /// G5: the deposit arm delivers a pressed item to the deposit belt and returns
        guarantee scenario ArmDeliversItemToDepositBelt {
          depositArm -> controller.pickedUpItem()
          urgent controller -> depositArm.moveTo(depositBelt)
          depositArm -> controller.arrivedAt(depositBelt)
          urgent controller -> depositArm.releaseItem()
          depositArm -> controller.releasedItem()
          urgent controller -> depositArm.moveTo(press)
        }
        /// A1: no queue of blanks forms at the feed belt
        assumption scenario NoBlankBeforePreviousIsPickedUp {
          feedBelt -> controller.blankArrived()
          feedArm -> controller.pickedUpItem()
        } constraints [ forbidden feedBelt -> controller.blankArrived() ]
        /// A2
        assumption scenario ArmPicksUp {
          controller -> arm.pickUp()
          strict eventually arm -> controller.pickedUpItem()
        }
        /// A3
        assumption scenario ArmArrives {
          var Location target
          controller -> arm.moveTo(bind target)
          strict eventually arm -> controller.arrivedAt(target)
        }
        /// A4
        assumption scenario ArmReleases {
          controller -> arm.releaseItem()
          strict eventually arm -> controller.releasedItem()
        }
        /// A5
        assumption scenario PressFinishes {
          controller -> press.startPressing()
          strict eventually press -> controller.pressingFinished()
        }
      }
    }
}
