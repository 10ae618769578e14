specification Answers {
  collaboration Lamp {
    guarantee scenario Answers {
      button -> control.pressed()
      urgent control -> bulp.on()
    }
  }
}
