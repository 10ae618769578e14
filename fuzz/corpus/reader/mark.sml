specification X { }
