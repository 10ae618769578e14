import "answers.sml"
specification More { }
